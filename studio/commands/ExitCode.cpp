#include "studio/commands/ExitCode.hpp"

#include <fcntl.h>
#include <fmt/format.h>

#include <cerrno>
#include <cstdio>
#include <new>
#include <system_error>
#include <tuple>

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

/// Never throws, also where standard error takes nothing.
int say(int code, const std::string& message) {
  std::fputs(("thinwall: " + message + "\n").c_str(), stderr);
  return code;
}

/// A program may be started without standard streams, as services are. Then the first files that it opened would take
/// their places, and get its messages.
void occupy_standard_streams() {
  for (const int stream : {0, 1, 2}) {
    // What is opened takes the lowest number that is free.
    if (::fcntl(stream, F_GETFD) < 0 && errno == EBADF) std::ignore = ::open("/dev/null", O_RDWR);
  }
}

/// Results that were said on standard output and have not arrived are a file that could not be written.
int finished(int code) {
  errno = 0;
  const bool has_arrived = std::fflush(stdout) == 0 && std::ferror(stdout) == 0;
  if (has_arrived || code != kExitGood) return code;
  const int reason = errno != 0 ? errno : EIO;
  return say(kExitNoPicture, "cannot write to standard output: " + std::generic_category().message(reason));
}

int caught_code_of(const std::function<int()>& command) {
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
  } catch (const std::system_error& error) {
    return say(kExitNoPicture, error.what());
  }
}

}  // namespace

int exit_code_of(const std::function<int()>& command) {
  occupy_standard_streams();
  return finished(caught_code_of(command));
}

}  // namespace thinwall
