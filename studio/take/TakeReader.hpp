#pragma once

#include <cstddef>
#include <filesystem>
#include <memory>
#include <string>
#include <vector>

#include "studio/record/Moment.hpp"
#include "studio/take/TakeWriter.hpp"

namespace thinwall {

/// Reads a take, complete or not.
class TakeReader {
 public:
  /// Throws TakeError: no such file, no take, cut short, another format version, damaged.
  explicit TakeReader(const std::filesystem::path& file);
  ~TakeReader();
  TakeReader(TakeReader&&) noexcept;
  TakeReader& operator=(TakeReader&&) noexcept;

  const TakeDescription& description() const;
  const TakeEnding& ending() const;
  const std::vector<double>& times() const;  // (steps), seconds, ascending

  /// The step of that index, bit for bit as it was written. Throws TakeError when its data are damaged.
  Moment moment(std::size_t step) const;

 private:
  struct Implementation;
  std::unique_ptr<Implementation> implementation_;
};

/// A take as something to render from.
class TakeSource final : public MomentSource {
 public:
  explicit TakeSource(const TakeReader& take) : take_(take) {}
  std::optional<Moment> next() override;
  std::vector<std::string> warnings() const override { return take_.ending().warnings; }
  std::string state_digest() const override { return take_.ending().state_digest; }

 private:
  const TakeReader& take_;
  std::size_t step_ = 0;
};

}  // namespace thinwall
