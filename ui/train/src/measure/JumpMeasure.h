#pragma once

#include <insonate/core/Transform.h>
#include <insonate/simulator/LiveImaging.h>
#include <insonate/train/LiveRates.h>

#include <QElapsedTimer>
#include <QObject>
#include <QTimer>
#include <functional>
#include <memory>
#include <optional>
#include <random>
#include <vector>

namespace insonate::ui {
class ViewWidget;
}

namespace insonate::train {

class CaseModel;
class LiveModel;
class ProbeMotion;

/// Moves the probe to random places of the skin, always the same ones for a case, and measures the time until the image
/// of the new position is on the screen.
class JumpMeasure : public QObject {
 public:
  /// `done` is called once, on the window's thread.
  JumpMeasure(const CaseModel& patientCase, LiveModel& live, ProbeMotion& motion, ui::ViewWidget& image, int jumps,
              std::function<void(JumpRates)> done);

 private:
  void jump();
  void drawn();
  void finish();
  std::optional<Transform> randomPose();

  const CaseModel& case_;
  LiveModel& live_;
  ProbeMotion& motion_;
  const int jumps_;
  std::function<void(JumpRates)> done_;
  std::mt19937 random_;
  QTimer pause_, patience_;
  QElapsedTimer since_;
  bool waiting_ = false;                     ///< true: the image of the last jump has not reached its full quality yet
  std::optional<double> first_ms_;           ///< time to the first image of the last jump
  std::vector<double> first_, full_;         ///< times of all jumps, ms
  std::shared_ptr<const LiveFrame> coarse_;  ///< first image of the last jump, if it is coarse
  std::vector<double> differences_;          ///< mean absolute differences of coarse images, gray levels
};

}  // namespace insonate::train
