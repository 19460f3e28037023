#pragma once

#include <insonate/ultrasound/ImagingSettings.h>
#include <insonate/views/LabelStyle.h>
#include <insonate/views/NamedPlace.h>
#include <insonate/views/PictureBounds.h>
#include <insonate/views/SliceCalliper.h>
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

/// A slice of the CT with its labels. Left drag moves the crosshair (with shift also without a button), right drag
/// changes window (across) and level (along), middle drag pans, the wheel and the arrow keys change the slice, the
/// wheel with control zooms; g shows and hides labels, a and d change their opacity, r resets the view.
class MprView final : public View {
 public:
  explicit MprView(SliceKind kind);
  ~MprView() override;

  /// Sets the case; null shows an empty view. Resets slice, zoom and crosshair.
  void setCase(std::shared_ptr<const VtkCase> patient);

  void setKind(SliceKind kind);
  SliceKind kind() const { return kind_; }
  /// The plane of an oblique view: the probe's, rigid. The crosshair is not moved.
  void setProbePose(const Transform& patientFromProbe);
  /// The field of view to outline on an oblique view; none for no outline.
  void setFan(std::optional<Probe> probe, const ImagingSettings& settings = {});

  /// Aligns an oblique view with these bounds in an UltrasoundView of the same size, and shows nothing outside the
  /// field of view; it does not zoom or pan then. None for a slice of its own.
  void setPicture(std::optional<PictureBounds> bounds);
  /// Marks the place that is pointed at in another view, where the slice passes through it; none for no mark.
  void setPointer(std::optional<Vec3> position_mm);
  /// Numbered points, shown where the slice passes by within 3 mm.
  void setMarks(std::vector<Vec3> positions_mm);
  bool showsMark(Vec3 position_mm) const;
  /// Sets calipers, which are drawn with their values where the slice passes through them, numbered in this order.
  void setCallipers(std::vector<SliceCalliper> callipers);

  /// Sets the crosshair, patient LPS mm; the slice shown is the one through it (oblique: the probe's plane).
  void setCrosshair(Vec3 position_mm);
  Vec3 crosshair_mm() const { return crosshair_mm_; }
  void setCrosshairVisible(bool visible);
  /// Called when the user moves the crosshair, by dragging or by changing the slice; not by setCrosshair.
  void setCrosshairMoved(std::function<void(Vec3 position_mm)> listener) { crosshairMoved_ = std::move(listener); }

  void setWindowLevel(WindowLevel value);
  WindowLevel windowLevel() const { return windowLevel_; }
  void setWindowLevelChanged(std::function<void(WindowLevel)> listener) { windowLevelChanged_ = std::move(listener); }

  void setLabelColour(std::uint8_t label, Colour colour);
  void setLabelVisible(std::uint8_t label, bool visible);
  void setLabelsVisible(bool visible);
  /// Shows only their outlines, at any opacity.
  void setLabelOutlines(bool only) { setLabelStyle({.fill = !only, .outline = true}); }
  void setLabelStyle(const LabelStyle& style);
  /// Sets the opacity of the fill, 0..1; outlines are stronger.
  void setLabelOpacity(double opacity);
  /// Sets the opacity of one label, as a share of that of all, 0..1.
  void setLabelShare(std::uint8_t label, double share);
  double labelOpacity() const { return labelOpacity_; }

  /// Sets a tool's proposal for a block of the patient's grid, shown over the labels; kNoProposal where it changes
  /// nothing. Null for none.
  static constexpr std::uint8_t kNoProposal = 255;
  void setProposal(const VoxelBox& box, std::shared_ptr<const LabelMap> labels);
  void setToolMarks(SliceMarks marks);
  /// Named places, shown where the slice passes by as near as showsMark() says.
  void setPlaces(std::vector<NamedPlace> places);

  /// Steps of whole slices along the normal; stops at the volume's ends.
  void stepSlices(int slices);
  void zoom(double factor);
  /// Zoom and pan so that the volume (oblique with a fan: the fan) fills the view.
  void fit();

  /// The slice as it is shown, for conversions between display and patient.
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
  bool outOfDate() const override;

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
  std::optional<PictureBounds> picture_;
  std::optional<Vec3> pointer_mm_;
  std::vector<SliceCalliper> callipers_;
  std::vector<Vec3> marks_mm_;
  Vec3 crosshair_mm_;
  bool crosshairVisible_ = true;
  std::function<void(Vec3)> crosshairMoved_;
  WindowLevel windowLevel_;
  std::function<void(WindowLevel)> windowLevelChanged_;
  std::array<Colour, 256> colours_{};
  std::array<bool, 256> visible_{};
  VoxelBox proposalBox_;
  std::shared_ptr<const LabelMap> proposal_;
  SliceMarks toolMarks_;
  std::vector<NamedPlace> places_;
  std::array<double, 256> shares_{};
  LabelStyle labelStyle_;
  bool labelsVisible_ = true;
  double labelOpacity_ = 0.25;
  Vec3 middle_mm_;  ///< once zoomed or panned: the patient point at the middle, but for its place along the normal
  double mm_per_px_ = 0.5;
  int zoomedIn_px_ = 0;  ///< the view's shorter side when it was zoomed or panned
  bool fitted_ = true;
  Button held_ = Button::None;
  DisplayPoint last_;
  double wheelRest_ = 0;
  std::unique_ptr<Drawing> drawing_;
};

}  // namespace insonate::views
