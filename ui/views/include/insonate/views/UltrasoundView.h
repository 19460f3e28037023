#pragma once

#include <insonate/ultrasound/Frames.h>
#include <insonate/views/Calliper.h>
#include <insonate/views/PictureBounds.h>
#include <insonate/views/View.h>

#include <memory>
#include <optional>
#include <span>
#include <string>
#include <vector>

namespace insonate::views {

/// Lines and handles over the image, for something that is being edited.
struct PictureGuide {
  std::vector<PicturePoint> outline;  ///< closed
  std::vector<PicturePoint> handles;
  std::vector<std::string> words;  ///< beside the handles; may be fewer
  int chosen = -1;                 ///< the handle that is held or has the keyboard
};

/// A mesh of the tissue in the image's plane, as it lies now.
struct PictureTissue {
  int columns = 0, rows = 0;        ///< of nodes; no mesh below two of each
  std::vector<PicturePoint> nodes;  ///< [row][column]
  std::vector<float> pressure_kPa;  ///< of its cells, (columns-1) x (rows-1)
};

/// The live image, as large as fits with square pixels, black around; a depth scale beside it, focus, gray bar, the
/// probe's marker, callipers. Axial 0 of the scale is the middle of the probe's face.
class UltrasoundView final : public View {
 public:
  UltrasoundView();
  ~UltrasoundView() override;

  /// Copies the gray values. While the image keeps its size, nothing is allocated or built. An image without pixels
  /// empties the view.
  void setImage(const BModeImage& image);
  /// Shows only this part, e.g. the field of view without the black beside it; none for the whole image.
  void setBounds(std::optional<PictureBounds> bounds);
  /// The marker's side (+lateral) is on the right, as the image has it; mirrored, on the left.
  void setMirrored(bool mirrored);

  void setFocus(std::optional<double> focus_mm);
  void setFrozen(bool frozen);
  void setScaleVisible(bool visible);
  void setGreyBarVisible(bool visible);
  /// Slider values in dB from face to depth, -20..20, drawn as a curve beside the image; empty for none.
  void setTgc(std::span<const double> tgc_dB);
  /// Marks the place that is pointed at in another view; none for no mark.
  void setPointer(std::optional<PicturePoint> point);
  /// Words over the image that say why it is not the usual one, or in its place what to wait for; empty for none.
  void setNotice(const std::string& words);
  /// Sets calipers, which are drawn with their values, numbered in this order.
  void setCallipers(std::vector<Calliper> callipers);

  /// Sets a guide, drawn over the image in the accent color; an empty guide for none.
  void setGuide(PictureGuide guide);

  /// Sets an overlay: some of the mesh's lines, and the pressure in its cells, in colors with their scale. Copies;
  /// call with each image, which it does not lay out again.
  void setTissue(const PictureTissue& tissue, bool grid, bool pressure);

  /// Display pixels to the image's mm and back, also outside the picture.
  PicturePoint pictureFromDisplay(DisplayPoint at) const;
  DisplayPoint displayFromPicture(PicturePoint point) const;
  /// Tells whether a display point is within the visible part of the image.
  bool onPicture(DisplayPoint at) const;
  double px_per_mm() const;

 protected:
  void layout() override;

 private:
  struct Drawing;
  PictureBounds bounds() const;
  PicturePlacement placement() const;
  void placePicture(const PictureBounds& shown);
  void drawGuide();
  void drawTissue();

  BModeImage shape_;  ///< size and place of the image; its pixels go straight to the texture
  std::optional<PictureBounds> bounds_;
  std::optional<double> focus_mm_;
  std::vector<double> tgc_dB_;
  std::vector<Calliper> callipers_;
  PictureGuide guide_;
  PictureTissue tissue_;
  std::optional<PicturePoint> pointer_;
  std::string notice_;
  bool mirrored_ = false, frozen_ = false, scaleVisible_ = true, greyBarVisible_ = true;
  bool gridVisible_ = false, pressureVisible_ = false;
  std::unique_ptr<Drawing> drawing_;
};

}  // namespace insonate::views
