#include "studio/commands/ExitCode.hpp"

#include <fmt/format.h>

#include <cstdio>
#include <new>

#include "engine/simulation/SimulationFailure.hpp"
#include "renderer/image/PngFile.hpp"
#include "renderer/picture/PictureFailure.hpp"
#include "studio/golden/GoldenApproval.hpp"
#include "studio/recorder/FolderLock.hpp"
#include "studio/recorder/Interruption.hpp"
#include "studio/scenario/InputError.hpp"
#include "studio/take/TakeError.hpp"

namespace thinwall {
namespace {

int say(int code, const std::string& message) {
  fmt::print(stderr, "thinwall: {}\n", message);
  return code;
}

}  // namespace

int exit_code_of(const std::function<int()>& command) {
  try {
    return command();
  } catch (const Interrupted& interrupted) {
    return say(interrupted.exit_code(), interrupted.what());
  } catch (const InputErrors& errors) {
    // Each of its lines names its own place.
    fmt::print(stderr, "{}\n", errors.what());
    return kExitBadInput;
  } catch (const UsageError& error) {
    return say(kExitBadInput, error.what());
  } catch (const TakeError& error) {
    return say(kExitBadInput, error.what());
  } catch (const GoldenError& error) {
    return say(kExitBadInput, error.what());
  } catch (const FolderInUse& error) {
    return say(kExitBadInput, error.what());
  } catch (const ImageUnreadable& error) {
    return say(kExitBadInput, error.what());
  } catch (const SimulationFailure& failure) {
    return say(kExitSimulationFailed, std::string("the simulation failed: ") + failure.what());
  } catch (const PictureFailure& failure) {
    return say(kExitNoPicture, failure.what());
  } catch (const std::bad_alloc&) {
    return say(kExitSimulationFailed, "there is not enough memory for this scenario");
  }
}

}  // namespace thinwall
