#pragma once

#include <insonate/ultrasound/ImagingSettings.h>
#include <insonate/views/ImageBounds.h>
#include <insonate/views/LabelStyle.h>
#include <insonate/views/NamedPoint.h>
#include <insonate/views/SliceCaliper.h>
#include <insonate/views/SliceMarks.h>
#include <insonate/views/SlicePlane.h>
#include <insonate/views/Theme.h>
#include <insonate/views/View.h>
#include <insonate/views/VtkCase.h>
#include <insonate/views/WindowLevel.h>

#include <array>
#include <cstdint>
#include <functional>
#include <memory>
#include <optional>
#include <vector>

namespace insonate::views {

/// A view of a CT slice with its labels. Left drag, or moving the mouse with Shift held, moves the crosshair. Right
/// drag changes window (horizontally) and level (vertically). Middle drag pans, the wheel and the arrow keys change the
/// slice, Ctrl+wheel zooms. G shows or hides labels, A and D change their opacity, R resets the view.
class MprView final : public View {
 public:
  explicit MprView(SliceKind kind);
  ~MprView() override;

  /// Sets the case; null: the view is empty. Resets slice, zoom and crosshair.
  void setCase(std::shared_ptr<const VtkCase> patient);

  void setKind(SliceKind kind);
  SliceKind kind() const { return kind_; }
  /// Sets the plane of an oblique view to the probe's image plane; the transform must be rigid. Does not move the
  /// crosshair.
  void setProbePose(const Transform& patientFromProbe);
  /// Sets the probe whose field of view is outlined in an oblique view; empty: no outline.
  void setFan(std::optional<Probe> probe, const ImagingSettings& settings = {});

  /// Aligns an oblique view with an UltrasoundView of the same size that shows these bounds. Only the field of view is
  /// shown, and zoom and pan are disabled. Empty: the view is not aligned.
  void setAlignedImage(std::optional<ImageBounds> bounds);
  /// Marks the position of the pointer in another view, if it lies in the slice; empty: no mark.
  void setPointer(std::optional<Vec3> position_mm);
  /// Sets points that are marked on the slice and numbered in this order. A point is shown if it is at most 3 mm from
  /// the slice.
  void setMarks(std::vector<Vec3> positions_mm);
  bool showsMark(Vec3 position_mm) const;
  /// Sets calipers, which are numbered in this order. Those that lie in the slice are drawn with their values.
  void setCalipers(std::vector<SliceCaliper> calipers);

  /// Sets the crosshair (patient space, LPS, mm), and shows the slice through the crosshair. An oblique view still
  /// shows the image plane.
  void setCrosshair(Vec3 position_mm);
  Vec3 crosshair_mm() const { return crosshair_mm_; }
  void setCrosshairVisible(bool visible);
  /// Sets a listener that is called when the user moves the crosshair by dragging or by changing the slice.
  /// setCrosshair() does not call it.
  void setCrosshairMoved(std::function<void(Vec3 position_mm)> listener) { crosshairMoved_ = std::move(listener); }

  void setWindowLevel(WindowLevel value);
  WindowLevel windowLevel() const { return windowLevel_; }
  void setWindowLevelChanged(std::function<void(WindowLevel)> listener) { windowLevelChanged_ = std::move(listener); }

  void setLabelColor(std::uint8_t label, Color color);
  void setLabelVisible(std::uint8_t label, bool visible);
  void setLabelsVisible(bool visible);
  /// Sets whether labels are drawn as outlines only, at any opacity.
  void setLabelOutlines(bool only) { setLabelStyle({.fill = !only, .outline = true}); }
  void setLabelStyle(const LabelStyle& style);
  /// Sets the opacity of the filled areas of labels, 0 to 1; outlines are more opaque.
  void setLabelOpacity(double opacity);
  /// Sets the opacity of one label as a fraction, 0 to 1, of the opacity that setLabelOpacity() has set.
  void setRelativeLabelOpacity(std::uint8_t label, double share);
  double labelOpacity() const { return labelOpacity_; }

  /// Value, in the label map of setProposal(), of voxels that the tool does not change.
  static constexpr std::uint8_t kNoProposal = 255;
  /// Shows the proposal of a tool over the labels: the labels that the tool would write in a box of the patient's grid;
  /// null: no proposal.
  void setProposal(const VoxelBox& box, std::shared_ptr<const LabelMap> labels);
  void setToolMarks(SliceMarks marks);
  /// Sets named points, which are shown if showsMark() is true for them.
  void setNamedPoints(std::vector<NamedPoint> places);

  /// Changes the slice by this number of slices along the normal, up to the ends of the volume.
  void stepSlices(int slices);
  void zoom(double factor);
  /// Sets zoom and pan so that the volume (for an oblique view with setFan(): the field of view) fills the view.
  void fit();

  /// Returns the displayed slice, which converts between display and patient.
  SlicePlane plane() const;
  Vec3 patientFromDisplay(DisplayPoint at) const { return plane().patientFromDisplay(at); }
  DisplayPoint displayFromPatient(Vec3 point_mm) const { return plane().displayFromPatient(point_mm); }

  bool pressed(const Pointer& pointer) override;
  bool moved(const Pointer& pointer) override;
  bool released(const Pointer& pointer) override;
  bool wheel(const Pointer& pointer, double notches) override;
  bool key(Key key) override;

 protected:
  void layout() override;
  bool isStale() const override;

 private:
  struct Drawing;
  void moveCrosshair(Vec3 position_mm);
  void fitTo(SlicePlane& plane) const;
  void stopFitting();
  void paintLabels();
  bool overFan() const { return kind_ == SliceKind::Oblique && fanProbe_; }
  bool asPicture() const { return overFan() && picture_; }
  bool passesThrough(Vec3 point_mm, const SlicePlane& plane) const;
  std::vector<DisplayPoint> fanOn(const SlicePlane& plane) const;
  void sample(const SlicePlane& plane, int firstRow, int endRow);

  SliceKind kind_;
  std::shared_ptr<const VtkCase> patient_;
  Transform patientFromProbe_;
  std::optional<Probe> fanProbe_;
  ImagingSettings fanSettings_;
  std::optional<ImageBounds> picture_;
  std::optional<Vec3> pointer_mm_;
  std::vector<SliceCaliper> calipers_;
  std::vector<Vec3> marks_mm_;
  Vec3 crosshair_mm_;
  bool crosshairVisible_ = true;
  std::function<void(Vec3)> crosshairMoved_;
  WindowLevel windowLevel_;
  std::function<void(WindowLevel)> windowLevelChanged_;
  std::array<Color, 256> colors_{};
  std::array<bool, 256> visible_{};
  VoxelBox proposalBox_;
  std::shared_ptr<const LabelMap> proposal_;
  SliceMarks toolMarks_;
  std::vector<NamedPoint> places_;
  std::array<double, 256> shares_{};
  LabelStyle labelStyle_;
  bool labelsVisible_ = true;
  double labelOpacity_ = 0.25;
  /// Point of the patient that zoom and pan have put at the center; its coordinate along the normal is not used.
  Vec3 middle_mm_;
  double mm_per_px_ = 0.5;
  int zoomedIn_px_ = 0;  ///< shorter side of the view at the last zoom or pan
  bool fitted_ = true;
  Button held_ = Button::None;
  DisplayPoint last_;
  double wheelRest_ = 0;
  std::unique_ptr<Drawing> drawing_;
};

}  // namespace insonate::views
