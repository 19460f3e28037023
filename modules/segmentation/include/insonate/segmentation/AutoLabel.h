#pragma once

#include <insonate/core/Progress.h>
#include <insonate/core/Result.h>
#include <insonate/image/Volume.h>

namespace insonate {

/// Labels what Hounsfield units and connectivity can tell, on the CT's own grid:
///   background   outside air, the couch, clothes, everything that is not the largest body
///   skin         a closed shell under the body's surface, 2 mm thick or down to where fat begins, at least 1 mm and
///                one voxel
///   airway       air inside the body: airway, lung with its small vessels, sinuses
///   fat          below -30 HU
///   bone         dense cores, what is denser than soft tissue around them, and the marrow they enclose
///   muscle       all other tissue that is thick enough, brain and organs included
///   soft tissue  thin strands between fat, and the lining of the airway
/// Contrast-filled vessels are not bone unless they are as dense as cortex; they become muscle.
///
/// Distances are in millimeters on any grid: anisotropic, oblique, either handedness. The ends of the scan across the
/// patient's head-foot axis, the edge of the image and padding are cuts, not skin. Memory: at most nine bytes a voxel
/// besides the CT. Uses the calling thread's TBB arena; may be called on several volumes at once. The same volume gives
/// the same labels on any number of threads.
///
/// Fails with kCancelled when the listener asks for it, with a sentence for a CT whose geometry is invalid or that
/// contains no body (nothing above -400 HU that is thicker than a couch), no air, or nearly nothing but one structure.
Result<LabelMap> autoLabel(const CtVolume& ct, const Progress& progress);

}  // namespace insonate
