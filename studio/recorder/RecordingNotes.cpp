#include "studio/recorder/RecordingNotes.hpp"

#include <algorithm>
#include <iterator>
#include <memory>
#include <utility>

#include "studio/recorder/CutTextNotes.hpp"
#include "studio/recorder/EmptyPictureNotes.hpp"
#include "studio/recorder/HiddenToolNotes.hpp"
#include "studio/recorder/InsetNotes.hpp"
#include "studio/recorder/ShortForceArrowNotes.hpp"
#include "studio/recorder/UnseenLabelNotes.hpp"

namespace thinwall {
namespace {

struct Noticed {
  InsetNotes insets = {};
  HiddenToolNotes hidden = {};
  EmptyPictureNotes empty = {};
  CutTextNotes texts = {};
  UnseenLabelNotes labels;
  ShortForceArrowNotes forces;
};

class NoticingPainter final : public Painter {
 public:
  NoticingPainter(std::unique_ptr<Painter> painter, Noticed& noticed, ImageSize size)
      : painter_(std::move(painter)), noticed_(noticed), size_(size) {}

  Image paint(const Snapshot& snapshot, const Shot& shot) override {
    noticed_.insets.see(snapshot, shot, size_);
    noticed_.hidden.see(snapshot, shot, size_);
    noticed_.empty.see(snapshot, shot, size_);
    noticed_.labels.see(snapshot, shot, size_);
    noticed_.forces.see(snapshot, shot, size_);
    return painter_->paint(snapshot, shot);
  }
  void see_cut_text(const std::string& text) override { noticed_.texts.see(text); }
  std::string driver() const override { return painter_->driver(); }
  std::vector<PassTime> pass_times() override { return painter_->pass_times(); }

 private:
  std::unique_ptr<Painter> painter_;
  Noticed& noticed_;
  ImageSize size_;
};

}  // namespace

RecordingReport record_with_notes(MomentSource& source, const RecordingPlan& plan, const PainterFactory& painters) {
  Noticed noticed{.labels = UnseenLabelNotes(plan.teaching.annotations.labels),
                  .forces = ShortForceArrowNotes(plan.teaching.annotations.force_arrows)};
  const PainterFactory noticing = [&](ImageSize size) {
    return std::make_unique<NoticingPainter>(painters(size), noticed, size);
  };
  RecordingReport report = record(source, plan, noticing);
  std::ranges::copy(noticed.insets.notes(), std::back_inserter(report.warnings));
  std::ranges::copy(noticed.hidden.notes(), std::back_inserter(report.warnings));
  std::ranges::copy(noticed.empty.notes(), std::back_inserter(report.warnings));
  std::ranges::copy(noticed.labels.notes(), std::back_inserter(report.warnings));
  std::ranges::copy(noticed.forces.notes(), std::back_inserter(report.warnings));
  std::ranges::copy(noticed.texts.notes(plan.size), std::back_inserter(report.warnings));
  return report;
}

}  // namespace thinwall
