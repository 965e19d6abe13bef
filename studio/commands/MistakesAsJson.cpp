#include "studio/commands/MistakesAsJson.hpp"

#include <nlohmann/json.hpp>

namespace thinwall {

nlohmann::ordered_json mistakes_as_json(const std::vector<Diagnostic>& mistakes) {
  nlohmann::ordered_json list = nlohmann::ordered_json::array();
  for (const Diagnostic& mistake : mistakes) {
    list.push_back({{"file", mistake.location.file.generic_string()},
                    {"line", mistake.location.line},
                    {"column", mistake.location.column},
                    {"message", mistake.message}});
  }
  return list;
}

}  // namespace thinwall
