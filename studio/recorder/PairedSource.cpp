#include "studio/recorder/PairedSource.hpp"

#include <algorithm>

#include "renderer/snapshot/SameTime.hpp"
#include "studio/recorder/FrameComposer.hpp"

namespace thinwall {
namespace {

class PairedSource final : public MomentSource {
 public:
  PairedSource(std::unique_ptr<MomentSource> first, std::unique_ptr<MomentSource> second)
      : first_(std::move(first)), second_(std::move(second)) {}

  std::optional<Moment> next() override {
    std::optional<Moment> moment = first_->next();
    if (moment) moment->second = second_at(moment->snapshot.time);
    return moment;
  }

  std::vector<std::string> warnings() const override {
    std::vector<std::string> all = first_->warnings();
    for (const std::string& warning : second_->warnings()) {
      const std::string told = "the second take: " + warning;
      // A recorded first take has kept what was told of the pair.
      if (std::ranges::find(all, told) == all.end()) all.push_back(told);
    }
    return all;
  }

  std::string state_digest() const override { return first_->state_digest(); }
  std::string second_state_digest() const override { return second_->state_digest(); }

 private:
  std::shared_ptr<const Moment> second_at(double time) {
    while (!ended_ && (!later_ || later_->snapshot.time < time - kSameTime)) {
      std::optional<Moment> moment = second_->next();
      ended_ = !moment;
      if (!moment) break;
      earlier_ = std::move(later_);
      later_ = std::make_shared<const Moment>(std::move(*moment));
    }
    if (!later_ || !earlier_ || later_->snapshot.time <= time + kSameTime) return later_;
    Moment between = *later_;
    between.snapshot = interpolate(earlier_->snapshot, later_->snapshot, time);
    return std::make_shared<const Moment>(std::move(between));
  }

  std::unique_ptr<MomentSource> first_;
  std::unique_ptr<MomentSource> second_;
  std::shared_ptr<const Moment> earlier_;  // of the second take
  std::shared_ptr<const Moment> later_;
  bool ended_ = false;
};

}  // namespace

std::unique_ptr<MomentSource> pair_sources(std::unique_ptr<MomentSource> first, std::unique_ptr<MomentSource> second) {
  return std::make_unique<PairedSource>(std::move(first), std::move(second));
}

}  // namespace thinwall
