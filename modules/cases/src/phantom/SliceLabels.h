#pragma once

#include "BodySurface.h"
#include "Structure.h"

#include <functional>
#include <span>
#include <vector>

namespace insonate::phantom {

/// One level of a grid whose axes are the patient's axes.
struct SliceGrid {
  double z_mm;
  std::uint32_t seed;
  Vec3 origin_mm, spacing_mm;
  int width, height;
};

/// Decides the label of every voxel of one level: layers of the skin, organs in order of precedence, muscles separated
/// by fascia, and fat and connective tissue in the rest. Only one thread at a time may use one object.
class SliceLabels {
 public:
  SliceLabels(std::span<const Structure> structures, BodySurface::Slice body, const Platysma& platysma, SliceGrid grid);

  /// Computes the position of each voxel in the model frame.
  void place(const std::function<Vec3(Vec3)>& modelFromPatient);
  /// Writes the labels of the level, width * height values, to `labels`.
  void paint(std::uint8_t* labels);

 private:
  struct Voxel {
    Site site;
    std::uint8_t organ = 0;  ///< label of the organ at the voxel; 0: none found yet
    /// True if the voxel lies in the soft tissue around an artery (arterial), a vein (venous) or another organ
    /// (walled).
    bool arterial = false, venous = false, walled = false;
    std::uint8_t muscle = 0;
    double muscle_mm = 1e9, nextMuscle_mm = 1e9;  ///< distances to the two nearest muscles
    double organ_mm = 1e9;                        ///< distance to the nearest organ that is wrapped in fascia
  };

  /// A square block of voxels and the bounding box of their model positions, used to skip blocks that a shape does not
  /// reach.
  struct Tile {
    int firstI, lastI, firstJ, lastJ;
    Box2 bounds_mm;
  };

  void makeTiles();
  void addOrgan(const Structure& structure, const Section& section);
  void addMuscle(const Structure& structure, const Section& section);
  template <class Visit>
  void within(const Section& section, Visit visit);
  std::uint8_t label(const Voxel& voxel) const;
  std::uint8_t superficial(const Voxel& voxel) const;
  bool isPlatysma(const Site& site, double fat_mm) const;
  std::uint8_t filling(const Voxel& voxel) const;

  std::span<const Structure> structures_;
  BodySurface::Slice body_;
  Platysma platysma_;
  SliceGrid grid_;
  std::vector<Voxel> voxels_;
  std::vector<Tile> tiles_;
};

}  // namespace insonate::phantom
