#include <fmt/format.h>

#include <nlohmann/json.hpp>

#include "studio/commands/Commands.hpp"
#include "studio/commands/ExitCode.hpp"
#include "studio/scenario/InputError.hpp"
#include "studio/scenario/LoadScenario.hpp"

namespace thinwall {

int check_scenarios(const CheckOptions& options) {
  nlohmann::ordered_json results = nlohmann::ordered_json::array();
  int code = kExitGood;
  for (const std::filesystem::path& file : options.scenarios) {
    nlohmann::ordered_json errors = nlohmann::ordered_json::array();
    try {
      const Scenario scenario = load_scenario(file, options.overrides);
      fmt::print(stderr, "{}: good\n", file.string());
    } catch (const InputErrors& mistakes) {
      code = kExitBadInput;
      fmt::print(stderr, "{}\n", mistakes.what());
      for (const Diagnostic& diagnostic : mistakes.diagnostics()) {
        errors.push_back({{"file", diagnostic.location.file.generic_string()},
                          {"line", diagnostic.location.line},
                          {"column", diagnostic.location.column},
                          {"message", diagnostic.message}});
      }
    }
    results.push_back({{"file", file.generic_string()}, {"good", errors.empty()}, {"errors", errors}});
  }
  if (options.json) {
    const nlohmann::ordered_json json = {{"scenarios", results}};
    fmt::print("{}\n", json.dump(2, ' ', false, nlohmann::json::error_handler_t::replace));
  }
  return code;
}

}  // namespace thinwall
