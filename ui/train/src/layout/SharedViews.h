#pragma once

#include <insonate/views/MprView.h>
#include <insonate/views/UltrasoundView.h>

#include <QObject>
#include <functional>
#include <memory>
#include <optional>
#include <vector>

class QWidget;

namespace insonate::ui {
class ViewWidget;
}

namespace insonate::train {

/// The ultrasound image, on which several features draw, and the other views of the workspace.
class SharedViews : public QObject {
  Q_OBJECT

 public:
  /// The image's widget is made in `parent`, for a layout to take.
  explicit SharedViews(QWidget& parent);

  views::UltrasoundView& image() { return *image_; }
  ui::ViewWidget& imageWidget() { return *imageWidget_; }

  /// A slice of the CT.
  struct Slice {
    views::MprView* view = nullptr;
    ui::ViewWidget* widget = nullptr;
  };
  /// Announces a slice to the features that measure and point on slices.
  void addSlice(const Slice& slice);
  const std::vector<Slice>& slices() const { return slices_; }
  /// Announces another view.
  void add(ui::ViewWidget& widget);
  /// Ends the full size of any view.
  void restoreSizes();

  /// Chooses the part of the imaging plane that the image shows for a field of view; nullopt: as it is.
  using Bounds = std::function<std::optional<views::PictureBounds>(const views::PictureBounds& fieldOfView)>;
  /// Replaces the choice, which is the field of view by default.
  void setBounds(Bounds bounds);
  std::optional<views::PictureBounds> boundsFor(const views::PictureBounds& fieldOfView) const;

 Q_SIGNALS:
  void added(insonate::ui::ViewWidget* widget);
  void sliceAdded(const insonate::train::SharedViews::Slice& slice);
  /// The user changed window or level of a slice.
  void windowLevelChanged(insonate::views::WindowLevel value);
  /// boundsFor() has another answer.
  void boundsChanged();

 private:
  std::shared_ptr<views::UltrasoundView> image_;
  ui::ViewWidget* imageWidget_;
  std::vector<Slice> slices_;
  std::vector<ui::ViewWidget*> widgets_;
  Bounds bounds_;
};

}  // namespace insonate::train
