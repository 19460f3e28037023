#pragma once

#include <insonate/segmentation/LabelStep.h>
#include <insonate/segmentation/SectionOutline.h>
#include <insonate/segmentation/StraightenedVessel.h>

#include <QObject>
#include <QString>
#include <QTimer>
#include <atomic>
#include <memory>
#include <optional>
#include <vector>

namespace insonate::prepare {

struct PrepareModel;

/// The selected vessel along its center line: the cross-section at the crosshair, the rotation of the straightened
/// view, and an outline that the author drags. The center lines of the selected label are computed on a background
/// thread. May be used only on the window's thread.
class VesselSession : public QObject {
  Q_OBJECT

 public:
  VesselSession(PrepareModel& shared, QObject* parent);
  ~VesselSession() override;

  /// Computes center lines only while it is active.
  void setActive(bool active);
  /// The course of the vessel at the crosshair; null if there is none, or while it is being computed.
  const VesselCourse* course() const { return courses_.empty() ? nullptr : &courses_[chosen_]; }
  /// Says why there is no course.
  const QString& reason() const { return reason_; }
  std::uint8_t label() const { return label_; }
  /// The CT, the displayed labels and the preview of a change. Valid until the next event; needs a course.
  VesselVolumes volumes() const;

  /// Number of the frame of the current section.
  std::size_t frame() const { return frame_; }
  /// Moves to a section, limited to the course. The crosshair follows.
  void moveTo(int frame);
  double angle_rad() const { return angle_rad_; }
  void rotate(double by_deg);

  /// Returns the outline of the label in a section.
  VesselOutline outlineAt(std::size_t frame) const;
  /// Returns the outline of the current section, as far as it has been dragged.
  VesselOutline outline() const;
  /// Returns the distance along the vessel, to both sides, up to which a drag changes the vessel.
  double reach_mm() const;
  /// Begins to drag the outline of the current section. Returns false, with a message, if the label may not change.
  bool beginDrag();
  /// Moves a corner of the outline to a distance from the center, and previews the change.
  void drag(int ray, double radius_mm);
  /// Writes the dragged outline as one step that can be undone.
  void endDrag();

 Q_SIGNALS:
  /// Emitted when the course or its reason has changed.
  void courseChanged();
  void moved();    ///< emitted when another section is the current one
  void rotated();  ///< emitted when the rotation of the straightened view has changed
  /// Emitted when the displayed labels or the preview have changed.
  void labelsChanged();
  void outlineDragged();

 private:
  struct Found {
    std::vector<VesselCourse> courses;
    QString reason;
  };

  /// Returns the step that writes the dragged outline.
  LabelStep draggedStep() const;
  void find();
  void take(Found found);
  void clear(const QString& reason);
  /// Goes to the section nearest to the crosshair, unless the crosshair is far from each course.
  void goToCrosshair();
  void followEdit();

  PrepareModel& shared_;
  std::vector<VesselCourse> courses_;
  std::size_t chosen_ = 0, frame_ = 0;
  QString reason_;
  std::uint8_t label_ = 0;
  double angle_rad_ = 0;
  std::optional<VesselOutline> start_, dragged_;  ///< the outline when the drag began, and as it was dragged
  std::shared_ptr<std::atomic<bool>> stop_;       ///< stops the running computation; null if none is running
  QTimer again_;
  bool active_ = false, moving_ = false, writing_ = false;
};

}  // namespace insonate::prepare
