#pragma once

#include "studio/recorder/Recorder.hpp"

namespace thinwall {

/// `record`, with what is noticed in its pictures among the warnings: see InsetNotes, HiddenToolNotes,
/// EmptyPictureNotes, UnseenLabelNotes, ShortForceArrowNotes and CutTextNotes.
RecordingReport record_with_notes(MomentSource& source, const RecordingPlan& plan, const PainterFactory& painters);

}  // namespace thinwall
