# Writes OUTPUT, a C++ file that holds the text of FILE for report_page().
file(READ "${FILE}" text)
file(WRITE "${OUTPUT}"
"#include \"studio/golden/ReportPage.hpp\"

namespace thinwall {

std::string_view report_page() {
  static constexpr std::string_view kPage = R\"html(${text})html\";
  return kPage;
}

}  // namespace thinwall
")
