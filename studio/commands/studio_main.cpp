#include <string>
#include <vector>

#include "studio/commands/CommandLine.hpp"

int main(int count, char** arguments) {
  return thinwall::run_command_line(std::vector<std::string>(arguments + 1, arguments + count));
}
