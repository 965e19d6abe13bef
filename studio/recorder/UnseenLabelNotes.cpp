#include "studio/recorder/UnseenLabelNotes.hpp"

#include <fmt/format.h>

#include "renderer/annotation/AnnotationDrawing.hpp"
#include "renderer/camera/PictureLayout.hpp"

namespace thinwall {

UnseenLabelNotes::UnseenLabelNotes(const std::vector<LabelDefinition>& labels) {
  for (const LabelDefinition& label : labels) labels_.push_back({.definition = label});
}

void UnseenLabelNotes::see(const Snapshot& snapshot, const Shot& shot, ImageSize size) {
  for (Label& label : labels_) {
    if (label.was_seen || !label.definition.span.holds(snapshot.time)) continue;
    label.was_asked_for = true;
    // The other half of a split screen may show it.
    label.was_seen = shot.beside || shows_point_of(label.definition, snapshot, shot.camera, main_box(shot, size).size);
  }
}

std::vector<std::string> UnseenLabelNotes::notes() const {
  std::vector<std::string> notes;
  for (std::size_t i = 0; i < labels_.size(); ++i) {
    const Label& label = labels_[i];
    if (!label.was_asked_for || label.was_seen) continue;
    notes.push_back(fmt::format(
        "teaching.labels[{}]: \"{}\" is in no picture: the place of body `{}` that is nearest to its `at` lies "
        "beside all of them; set `at` to a place that the camera sees, or the camera so that it sees this one",
        i + 1, label.definition.text, label.definition.body));
  }
  return notes;
}

}  // namespace thinwall
