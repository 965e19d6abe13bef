#include "studio/commands/ExitCode.hpp"

#include <fcntl.h>
#include <fmt/format.h>

#include <algorithm>
#include <cerrno>
#include <cstdio>
#include <new>
#include <nlohmann/json.hpp>
#include <system_error>
#include <tuple>

#include "engine/simulation/SimulationFailure.hpp"
#include "renderer/image/PictureFailure.hpp"
#include "renderer/image/PngFile.hpp"
#include "studio/commands/JsonAnswer.hpp"
#include "studio/commands/MistakesAsJson.hpp"
#include "studio/commands/StandardOutput.hpp"
#include "studio/golden/GoldenApproval.hpp"
#include "studio/recorder/FolderLock.hpp"
#include "studio/recorder/Interruption.hpp"
#include "studio/scenario/InputError.hpp"
#include "studio/take/TakeError.hpp"

namespace thinwall {
namespace {

using Json = nlohmann::ordered_json;

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

/// Results that were said on standard output and have not arrived are a file that could not be written. What has failed
/// besides is the worse.
int finished(int code) {
  const int reason = standard_output_error();
  if (reason == 0) return code;
  say(kExitNoPicture, "cannot write to standard output: " + std::generic_category().message(reason) +
                          "; free some space where it goes, or let it go elsewhere");
  return code == kExitGood ? kExitNoPicture : code;
}

/// Why a command could not do its work.
struct Failure {
  int code = kExitGood;
  std::string message = {};
  std::vector<Diagnostic> mistakes = {};  // with their places, where the input is to blame
};

Failure caught_failure_of(const std::function<int()>& command) {
  try {
    return {command()};
  } catch (const Interrupted& interrupted) {
    return {interrupted.exit_code(), interrupted.what()};
  } catch (const InputErrors& errors) {
    return {kExitBadInput, errors.what(), errors.diagnostics()};
  } catch (const UsageError& error) {
    return {kExitBadInput, error.what()};
  } catch (const TakeError& error) {
    return {kExitBadInput, error.what()};
  } catch (const GoldenError& error) {
    return {kExitBadInput, error.what()};
  } catch (const FolderInUse& error) {
    return {kExitBadInput, error.what()};
  } catch (const ImageUnreadable& error) {
    return {kExitBadInput, error.what()};
  } catch (const SimulationFailure& failure) {
    return {kExitSimulationFailed, std::string("the simulation failed: ") + failure.what()};
  } catch (const PictureFailure& failure) {
    return {kExitNoPicture, failure.what()};
  } catch (const std::bad_alloc&) {
    return {kExitSimulationFailed, "there is not enough memory for this scenario"};
  } catch (const std::system_error& error) {
    return {kExitNoPicture, error.what()};
  }
}

void tell(const Failure& failure, FailureAs as) {
  // Each line of mistakes in the input names its own place.
  if (!failure.mistakes.empty()) {
    std::fputs((failure.message + "\n").c_str(), stderr);
  } else {
    say(failure.code, failure.message);
  }
  if (as != FailureAs::kMessageAndJson) return;
  Json json = {{"result", "failed"}, {"exit_code", failure.code}, {"failure", failure.message}};
  if (!failure.mistakes.empty()) json["errors"] = mistakes_as_json(failure.mistakes);
  print_json(json);
}

}  // namespace

FailureAs failure_as(const std::vector<std::string>& arguments) {
  return std::ranges::find(arguments, "--json") == arguments.end() ? FailureAs::kMessage : FailureAs::kMessageAndJson;
}

int exit_code_of(const std::function<int()>& command, FailureAs as) {
  occupy_standard_streams();
  const Failure failure = caught_failure_of(command);
  if (!failure.message.empty()) tell(failure, as);
  return finished(failure.code);
}

}  // namespace thinwall
