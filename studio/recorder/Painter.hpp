#pragma once

#include <functional>
#include <memory>
#include <string>
#include <vector>

#include "renderer/camera/View.hpp"
#include "renderer/device/DeviceChoice.hpp"
#include "renderer/image/Image.hpp"
#include "renderer/picture/Renderer.hpp"
#include "studio/recorder/FrameComposer.hpp"

namespace thinwall {

/// Draws frames. Made and used by one thread, because a GL context belongs to a thread.
class Painter {
 public:
  virtual ~Painter() = default;
  /// What the shot's cameras see, without overlays.
  virtual Image paint(const Snapshot& snapshot, const Shot& shot) = 0;
  /// Is told each text over a painted picture of which a part is not shown.
  virtual void see_cut_text(const std::string& /*text*/) {}
  /// What draws, as it names itself.
  virtual std::string driver() const = 0;
  /// What the passes of the pictures took, the median of those that have them, in their order, and as the last an empty
  /// frame; nothing from a painter that does not time them.
  virtual std::vector<PassTime> pass_times() { return {}; }
};

/// A frame as it is recorded: painted, with annotations, overlays and card.
Image finished_picture(const Frame& frame, Painter& painter);

/// Makes a painter for pictures of a size. Throws PictureFailure when there is no device for it.
using PainterFactory = std::function<std::unique_ptr<Painter>(ImageSize)>;

/// Painters that draw with the renderer, in the view's light and look.
/// `is_timed`: the driver is made to end each pass before the next begins, so that each can be timed.
PainterFactory renderer_painters(const DeviceChoice& device, Tier tier, const ViewDefinition& view,
                                 bool is_timed = false);

/// A line for each pass, in milliseconds of wall and processor time.
std::string pass_table(const std::vector<PassTime>& times);

}  // namespace thinwall
