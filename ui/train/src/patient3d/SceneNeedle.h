#pragma once

#include <insonate/core/Transform.h>
#include <insonate/views/SceneView.h>

#include <QObject>
#include <optional>

namespace insonate::train {

class CaseModel;
class HapticControl;
class StatusLine;

/// The needle in 3D, the tray with a new needle beside the patient's chest, and the cut along the needle.
class SceneNeedle final : public QObject {
  Q_OBJECT

 public:
  SceneNeedle(HapticControl& hands, CaseModel& patientCase, StatusLine& status, views::SceneView& scene,
              QObject* parent);

  /// Draws the needle in its present pose.
  void follow();
  /// Sets the color of the shaft.
  void setColor(views::Color color);

  /// Shows the tray on the side away from the probe, or hides it.
  void setTray(bool isVisible, Vec3 probe_mm);
  const std::optional<Transform>& tray() const { return tray_; }
  /// Tells whether a point lies on the tray or just above it, so that a needle's tip at the point touches the tray.
  bool isOnTray(Vec3 patient_mm) const;

  /// Cuts the patient open along the needle, toward the viewer, or closes the cut.
  void toggleCut();
  /// Closes the cut along the needle if there is one.
  void removeCut();

 Q_SIGNALS:
  /// Emitted when the needle's displayed pose or color has changed.
  void changed();

 private:
  std::optional<Transform> drawn() const;  ///< pose of the needle that is drawn

  HapticControl& hands_;
  CaseModel& patientCase_;
  StatusLine& status_;
  views::SceneView& scene_;
  views::Color color_ = views::theme::kText;
  std::optional<views::Clipping> cut_;
  std::optional<Transform> tray_;
};

}  // namespace insonate::train
