#pragma once

#include <insonate/core/Progress.h>
#include <insonate/core/Result.h>
#include <insonate/image/Volume.h>

namespace insonate {

/// Labels those structures of a CT that can be distinguished by Hounsfield units and connectivity. The label map has
/// the grid of the CT, and these labels:
/// - background: everything except the largest body, such as outside air, the couch and clothes
/// - skin: a closed shell under the body's surface, at least 1 mm and one voxel thick. The shell is 2 mm thick, or ends
///   at the fat if the fat begins earlier.
/// - airway: air inside the body, in the airway, the lung (with its small vessels) and the sinuses
/// - fat: tissue below -30 HU
/// - bone: dense cores, the surroundings of the cores that are denser than soft tissue, and the enclosed marrow
/// - muscle: all other tissue that is thick enough, including brain and organs
/// - soft tissue: thin strands between fat, and the lining of the airway
/// Vessels with contrast agent are labeled muscle, or bone if they are as dense as cortical bone.
///
/// Distances are in millimeters on any grid: anisotropic, oblique, of either handedness. The ends of the scan along the
/// patient's head-foot axis, the edge of the image and padding are treated as cuts through the body and get no skin.
/// Uses at most nine bytes of memory per voxel in addition to the CT. Uses the calling thread's TBB arena; may be
/// called for several volumes at once. The same volume gives the same labels on any number of threads.
///
/// Fails with kCancelled when `progress` asks for cancellation. Fails with a sentence if the CT's geometry is invalid,
/// if the CT contains no body (nothing above -400 HU that is thicker than a couch) or no air, or if nearly all of the
/// CT is one structure.
Result<LabelMap> autoLabel(const CtVolume& ct, const Progress& progress);

}  // namespace insonate
