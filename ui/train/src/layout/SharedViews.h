#pragma once

#include <insonate/views/MprView.h>
#include <insonate/views/UltrasoundView.h>

#include <QObject>
#include <functional>
#include <memory>
#include <optional>
#include <vector>

class QKeyEvent;
class QWidget;

namespace insonate::ui {
class Commands;
class ViewWidget;
}  // namespace insonate::ui

namespace insonate::train {

/// The views that several features use: the ultrasound image and the other views of the workspace.
class SharedViews : public QObject {
  Q_OBJECT

 public:
  /// Function that tells whether a view uses a key itself, although a command may have the key.
  using OwnKeys = std::function<bool(const QKeyEvent& event)>;

  /// The image's widget becomes a child of `parent`; a layout can move it. Keys in all views are passed to `commands`,
  /// which must outlive the views.
  SharedViews(const ui::Commands& commands, QWidget& parent);

  views::UltrasoundView& image() { return *image_; }
  ui::ViewWidget& imageWidget() { return *imageWidget_; }

  /// A CT slice and its widget.
  struct Slice {
    views::MprView* view = nullptr;
    ui::ViewWidget* widget = nullptr;
  };
  /// Registers a slice, for the features that measure and point on slices.
  void addSlice(const Slice& slice, OwnKeys ownKeys = {});
  const std::vector<Slice>& slices() const { return slices_; }
  /// Registers another view. Its keys are passed to the commands, except `ownKeys`.
  void add(ui::ViewWidget& widget, OwnKeys ownKeys = {});
  /// Ends the maximized state of any view.
  void restoreSizes();

  /// Function that returns the part of the imaging plane to show for a field of view; nullopt: the bounds stay as they
  /// are.
  using Bounds = std::function<std::optional<views::ImageBounds>(const views::ImageBounds& fieldOfView)>;
  /// Sets the function that returns the bounds; by default, the field of view is shown.
  void setBounds(Bounds bounds);
  std::optional<views::ImageBounds> boundsFor(const views::ImageBounds& fieldOfView) const;

 Q_SIGNALS:
  void sliceAdded(const insonate::train::SharedViews::Slice& slice);
  /// Emitted when the user changes window or level of a slice.
  void windowLevelChanged(insonate::views::WindowLevel value);
  /// Emitted when boundsFor() returns a new value.
  void boundsChanged();

 private:
  const ui::Commands& commands_;
  std::shared_ptr<views::UltrasoundView> image_;
  ui::ViewWidget* imageWidget_;
  std::vector<Slice> slices_;
  std::vector<ui::ViewWidget*> widgets_;
  Bounds bounds_;
};

}  // namespace insonate::train
