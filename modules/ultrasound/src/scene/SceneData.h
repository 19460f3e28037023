#pragma once

#include "scene/BoundaryProfiles.h"
#include "scene/TextureTiles.h"
#include "scene/TissueField.h"

#include <insonate/ultrasound/AcousticScene.h>

#include <cstdint>

namespace insonate {

/// Orientation of a texture in the patient: rows are the tile's u (fiber), v and w (thin) axes, in tile voxels per mm.
struct TextureFrame {
  Transform tileFromPatient;
  Vec3 thinAxis;  ///< direction of the tile's thin axis w, unit, patient LPS
};

struct AcousticScene::Impl {
  /// Number that is unique among the scenes of the process, even if an address is reused; above 0.
  std::uint64_t serial = 0;
  AcousticTable table;
  TissueField field;
  BoundaryProfiles profiles;
  std::vector<PointTarget> points;
  std::vector<std::string> warnings;
  Vec3 textureOrigin_mm;  ///< patient point at which all texture tiles begin; different for each patient
  double midline_mm = 0;  ///< x of the patient's midline; textures are mirrored across it
  double trachea_mm = 0;  ///< x of the trachea; gas far from it is lung
  /// Orientation of each label's texture, [label][0 right, 1 left of the midline].
  std::array<std::array<TextureFrame, 2>, kLabelCount> textureFrames;
};

}  // namespace insonate
