#pragma once

#include <insonate/haptics/TissueGrid.h>
#include <insonate/image/Volume.h>
#include <insonate/segmentation/CenterLine.h>

#include <condition_variable>
#include <memory>
#include <mutex>
#include <optional>
#include <thread>
#include <vector>

namespace insonate {

/// Computes the grid of tissue that the needle feels (TissueGrid), on its own thread, which stops within a tenth of a
/// second.
class GridMaker {
 public:
  /// Extent of the grid from its center to either side, along each axis of the label map.
  static constexpr double kReach_mm = 50;
  /// Distance of the center along the tool; a tool that is farther than kElsewhere_mm from it needs another grid.
  static constexpr double kAhead_mm = 20, kElsewhere_mm = 35;

  GridMaker();
  ~GridMaker();

  struct Made {
    std::shared_ptr<const TissueGrid> grid;  ///< tissue grid; null: the label map does not reach the requested point
    std::shared_ptr<const std::vector<CenterLine>> veins;  ///< center lines of the case's veins
    Vec3 center_mm;
  };
  /// Requests the grid around `center_mm`; a former request is dropped.
  void want(std::shared_ptr<const LabelMap> labels, Vec3 center_mm);
  void forget();
  /// Returns the grid that was requested last; empty if it is not ready or was already returned.
  std::optional<Made> take();

 private:
  void run(const std::stop_token& stop);
  void findVeins(const std::shared_ptr<const LabelMap>& labels, const Progress& progress);

  struct Wish {
    std::shared_ptr<const LabelMap> labels;
    Vec3 center_mm;
    int number = 0;
  };
  std::mutex mutex_;
  std::condition_variable_any changed_;
  Wish wish_;
  int begun_ = 0;
  std::optional<Made> made_;
  // Center lines of veins, and the label map to which they belong; used only by the thread, set once for each case.
  std::weak_ptr<const LabelMap> veinsOf_;
  std::shared_ptr<const std::vector<CenterLine>> veins_;
  std::jthread thread_;  // declared last, since the thread uses the other members
};

}  // namespace insonate
