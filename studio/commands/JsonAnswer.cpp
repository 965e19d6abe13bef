#include "studio/commands/JsonAnswer.hpp"

#include <nlohmann/json.hpp>

#include "studio/commands/StandardOutput.hpp"

namespace thinwall {

void print_json(const nlohmann::ordered_json& answer) {
  say_result(answer.dump(2, ' ', false, nlohmann::ordered_json::error_handler_t::replace) + "\n");
}

}  // namespace thinwall
