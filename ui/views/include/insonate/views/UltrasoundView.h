#pragma once

#include <insonate/core/Vec3.h>
#include <insonate/ultrasound/ColorDisplay.h>
#include <insonate/ultrasound/Frames.h>
#include <insonate/views/Caliper.h>
#include <insonate/views/ImageBounds.h>
#include <insonate/views/View.h>

#include <memory>
#include <optional>
#include <span>
#include <string>
#include <vector>

namespace insonate::views {

/// Outline and handles that are drawn over the image while the user edits a shape, e.g. the field of view.
struct ShapeOverlay {
  std::vector<ImagePoint> outline;  ///< outline, a closed polygon
  std::vector<ImagePoint> handles;
  std::vector<std::string> words;  ///< labels of the handles; may be fewer than handles
  int chosen = -1;                 ///< index of the handle that is held or has the keyboard focus
};

/// The path that a needle would take if it were advanced.
struct NeedlePathOverlay {
  std::optional<ImagePoint> tip;    ///< the needle's tip, if it lies within the slice thickness
  std::vector<ImagePoint> line;     ///< two points on the projection of the needle's axis beyond the tip; or empty
  std::optional<ImagePoint> cross;  ///< point at which the needle's axis crosses the image plane beyond the tip
  bool operator==(const NeedlePathOverlay&) const = default;
};

/// Name of a structure, written at its position in the image.
struct NameOverlay {
  ImagePoint at;
  std::string words;
  bool operator==(const NameOverlay&) const = default;
};

/// Straight line over the image, e.g. a scanline from which a trace over time is made.
struct LineOverlay {
  ImagePoint from, to;
  bool isFine = false;  ///< true: drawn less conspicuously
  bool operator==(const LineOverlay&) const = default;
};

/// Mesh of the tissue in the image plane at its present positions.
struct TissueOverlay {
  int columns = 0, rows = 0;        ///< number of nodes in each direction; there is no mesh if either is below 2
  std::vector<ImagePoint> nodes;    ///< positions of the nodes in row-major order
  std::vector<float> pressure_kPa;  ///< pressure in the mesh's cells, (columns-1) x (rows-1) values
};

/// A view of the live image, as large as possible with square pixels, on black, with depth scale, focus, gray bar, the
/// probe's marker and calipers. Depth 0 of the scale is at the center of the probe's face.
class UltrasoundView final : public View {
 public:
  UltrasoundView();
  ~UltrasoundView() override;

  /// Copies the gray values of an image. Allocates nothing while the image size does not change. With an image without
  /// pixels, the view becomes empty.
  void setImage(const BModeImage& image);
  /// Sets color Doppler of the image that setImage() has set, with the scale of its colors and the velocities at the
  /// ends of the scale; an empty color image: none. Call it after setImage().
  void setColor(const ColorImage& color);
  /// Shows only this part of the image, e.g. the field of view without the black areas beside it; empty: the whole
  /// image.
  void setBounds(std::optional<ImageBounds> bounds);
  /// Sets whether the image is mirrored. Normally the marker's side (+lateral) is on the right; mirrored, on the left.
  void setMirrored(bool mirrored);

  /// Sets the direction of +lateral in patient space (LPS). According to this direction, the sides of the image are
  /// marked R and L, A and P, or Head and Foot; empty: no marks. The layout is updated only if a mark changes.
  void setLateral(std::optional<Vec3> lateral);
  void setFocus(std::optional<double> focus_mm);
  void setFrozen(bool frozen);
  void setScaleVisible(bool visible);
  void setGrayBarVisible(bool visible);
  /// Sets the TGC sliders' values in dB, -20 to 20, from the probe's face downward, drawn as a curve beside the image;
  /// empty: no curve.
  void setTgc(std::span<const double> tgc_dB);
  /// Marks the position of the pointer in another view; empty: no mark.
  void setPointer(std::optional<ImagePoint> point);
  /// Sets a notice that is written over the image. The notice says how the image differs from a normal one or, if there
  /// is no image, why there is none. Empty: no notice.
  void setNotice(const std::string& words);
  const std::string& notice() const { return notice_; }
  /// Marks an image that does not belong to the present position or time: the image is dimmed, and the words stand
  /// across it. Empty: no mark.
  void setStaleMark(const std::string& words);
  const std::string& staleMark() const { return staleMark_; }
  /// Sets calipers, which are drawn with their values and numbered in this order.
  void setCalipers(std::vector<Caliper> calipers);

  /// Sets the outline and handles of a shape that the user edits, drawn over the image in the accent color; an overlay
  /// without points: none.
  void setGuide(ShapeOverlay guide);

  /// Sets the path that the needle would take. It is drawn as a dashed line, with a ring at the tip, and a cross where
  /// the needle's axis crosses the image plane.
  void setNeedlePath(NeedlePathOverlay aim);
  /// Returns the path that setNeedlePath() has set.
  const NeedlePathOverlay& aim() const { return aim_; }
  /// Sets lines that are drawn over the image.
  void setLines(std::vector<LineOverlay> lines);
  const std::vector<LineOverlay>& lines() const { return lines_; }
  /// Sets names of structures, written over the image.
  void setNames(std::vector<NameOverlay> names);
  const std::vector<NameOverlay>& names() const { return names_; }

  /// Sets an overlay of the tissue. `grid`, true: some of the lines of the mesh are drawn; `pressure`, true: the
  /// pressure in the cells is shown by colors, with a color scale. Copies its arguments. The function does not update
  /// the layout, so that it can be called with each image.
  void setTissue(const TissueOverlay& tissue, bool grid, bool pressure);

  /// Converts a position in display pixels to mm in the ultrasound image, also for positions outside the image;
  /// displayFromImage() converts back.
  ImagePoint imageFromDisplay(DisplayPoint at) const;
  DisplayPoint displayFromImage(ImagePoint point) const;
  /// Tells whether a display point is within the visible part of the image.
  bool isOnImage(DisplayPoint at) const;
  double px_per_mm() const;

 protected:
  void layout() override;

 private:
  struct Drawing;
  ImageBounds bounds() const;
  ImagePlacement placement() const;
  void placePicture(const ImageBounds& shown);
  void drawGuide();
  void drawAim();
  void drawLines();
  void drawNames();
  void drawStaleMark();
  /// Returns the upper corner of the image, or of the field of view that is being edited, on the marker's side (true)
  /// or on the other side (false).
  DisplayPoint cornerOf(bool marker) const;
  void drawSides();
  void drawTissue();
  void placeColor(const ImageBounds& shown);
  void drawColorScale();

  BModeImage shape_;  ///< size and position of the image; its pixels are stored in the texture only
  ColorImage color_;  ///< place and scale of color; its pixels are stored in the texture only
  std::optional<ImageBounds> bounds_;
  std::optional<double> focus_mm_;
  std::vector<double> tgc_dB_;
  std::vector<Caliper> calipers_;
  ShapeOverlay guide_;
  NeedlePathOverlay aim_;
  std::vector<LineOverlay> lines_;
  std::vector<NameOverlay> names_;
  TissueOverlay tissue_;
  std::optional<ImagePoint> pointer_;
  std::string notice_, staleMark_;
  std::string markerSide_, otherSide_;  ///< sides of the patient toward which +lateral and -lateral point
  bool mirrored_ = false, frozen_ = false, scaleVisible_ = true, grayBarVisible_ = true;
  bool gridVisible_ = false, pressureVisible_ = false;
  std::unique_ptr<Drawing> drawing_;
};

}  // namespace insonate::views
