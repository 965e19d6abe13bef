#include "tests/benchmarks/engine/published/OperationCount.hpp"

#include <sys/ptrace.h>
#include <sys/user.h>
#include <sys/wait.h>
#include <unistd.h>

#include <csignal>
#include <cstdint>
#include <stdexcept>

namespace thinwall {
namespace {

// Sections "Instruction format" of the AMD64 architecture programmer's manual, volumes 3 and 4, and of the AVX-512
// extensions: prefixes that say operand kind and width, then the opcode.

/// pp: the operand kind: 0 packed single, 1 packed double, 2 scalar single, 3 scalar double.
constexpr int kPackedDouble = 1, kScalarDouble = 3;

/// Operations of an instruction of opcode map 1 (0F).
int of_arithmetic(std::uint8_t opcode, int kind, int lanes) {
  const bool counts = opcode == 0x58 || opcode == 0x59 || opcode == 0x5C || opcode == 0x5E || opcode == 0x51;
  if (!counts) return 0;
  return kind == kScalarDouble ? 1 : kind == kPackedDouble ? lanes : 0;
}

/// Operations of an instruction of opcode map 2 (0F38): fused multiply-adds, whose odd opcodes are scalar from x9 on.
int of_fused(std::uint8_t opcode, bool wide, int lanes) {
  const int row = opcode >> 4, column = opcode & 15;
  if (!wide || (row != 9 && row != 0xA && row != 0xB) || column < 6) return 0;
  const bool scalar = column >= 9 && column % 2 == 1;
  return 2 * (scalar ? 1 : lanes);
}

int operations_of(const std::uint8_t* code) {
  if (code[0] == 0xC5) {
    const int kind = code[1] & 3, lanes = (code[1] & 4) != 0 ? 4 : 2;
    return of_arithmetic(code[2], kind, lanes);
  }
  if (code[0] == 0xC4) {
    const int map = code[1] & 31, kind = code[2] & 3, lanes = (code[2] & 4) != 0 ? 4 : 2;
    if (map == 1) return of_arithmetic(code[3], kind, lanes);
    return map == 2 && kind == 1 ? of_fused(code[3], (code[2] & 0x80) != 0, lanes) : 0;
  }
  if (code[0] == 0x62) {
    const int map = code[1] & 7, kind = code[2] & 3, lanes = 2 << ((code[3] >> 5) & 3);
    if (map == 1) return of_arithmetic(code[4], kind, lanes);
    return map == 2 && kind == 1 ? of_fused(code[4], (code[2] & 0x80) != 0, lanes) : 0;
  }
  int kind = 0;
  for (; *code == 0x66 || *code == 0xF2 || *code == 0xF3; ++code) {
    kind = *code == 0x66 ? 1 : *code == 0xF3 ? 2 : 3;
  }
  if ((*code & 0xF0) == 0x40) ++code;  // REX
  return code[0] == 0x0F ? of_arithmetic(code[1], kind, 2) : 0;
}

}  // namespace

double count_operations(const std::function<void()>& work) {
  const pid_t copy = fork();
  if (copy == 0) {
    if (ptrace(PTRACE_TRACEME, 0, nullptr, nullptr) != 0) _exit(1);
    raise(SIGSTOP);
    work();
    raise(SIGUSR1);
    _exit(0);
  }
  int status = 0;
  waitpid(copy, &status, 0);
  if (!WIFSTOPPED(status)) throw std::runtime_error("operations cannot be counted: tracing is not permitted here");
  double operations = 0;
  for (;;) {
    if (ptrace(PTRACE_SINGLESTEP, copy, nullptr, nullptr) != 0) break;
    waitpid(copy, &status, 0);
    if (!WIFSTOPPED(status) || WSTOPSIG(status) != SIGTRAP) break;
    user_regs_struct registers{};
    ptrace(PTRACE_GETREGS, copy, nullptr, &registers);
    // The copy has the same code at the same places as this process.
    operations += operations_of(reinterpret_cast<const std::uint8_t*>(registers.rip));
  }
  kill(copy, SIGKILL);
  waitpid(copy, &status, 0);
  return operations;
}

}  // namespace thinwall
