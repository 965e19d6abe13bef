#pragma once

#include <string_view>

namespace thinwall {

/// The text of report.html, into which the results are put.
std::string_view report_page();

}  // namespace thinwall
