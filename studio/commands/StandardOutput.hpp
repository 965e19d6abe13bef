#pragma once

#include <string_view>

namespace thinwall {

/// Says results on standard output. Where that takes none, as on a full disk, the command goes on, and ends as
/// `standard_output_error` has it.
void say_result(std::string_view text);

/// Why standard output has not taken all that was said there: a number of errno, 0 where it has.
int standard_output_error();

}  // namespace thinwall
