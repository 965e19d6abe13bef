#include "studio/commands/JsonAnswer.hpp"

#include <fmt/format.h>

#include <nlohmann/json.hpp>

namespace thinwall {

void print_json(const nlohmann::ordered_json& answer) {
  fmt::print("{}\n", answer.dump(2, ' ', false, nlohmann::ordered_json::error_handler_t::replace));
}

}  // namespace thinwall
