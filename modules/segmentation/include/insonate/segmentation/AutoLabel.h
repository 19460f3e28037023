#pragma once

#include <insonate/core/Progress.h>
#include <insonate/core/Result.h>
#include <insonate/image/Volume.h>

namespace insonate {

/// Labels the structures that Hounsfield units and connectivity can distinguish, on the CT's own grid:
///   background   outside air, the couch, clothes: everything except the largest body
///   skin         a closed shell under the body's surface, 2 mm thick or down to the fat if that begins earlier; at
///                least 1 mm and one voxel
///   airway       air inside the body: airway, lung with its small vessels, sinuses
///   fat          below -30 HU
///   bone         dense cores, the surroundings of the cores that are denser than soft tissue, and the enclosed marrow
///   muscle       all other tissue that is thick enough, including brain and organs
///   soft tissue  thin strands between fat, and the lining of the airway
/// Contrast-filled vessels are labeled muscle, unless they are as dense as cortical bone.
///
/// Distances are in millimeters on any grid: anisotropic, oblique, either handedness. The ends of the scan along the
/// patient's head-foot axis, the edge of the image and padding are cuts through the body; they get no skin. Memory: at
/// most nine bytes per voxel besides the CT. Uses the calling thread's TBB arena; may be called for several volumes at
/// once. The same volume gives the same labels on any number of threads.
///
/// Fails with kCancelled when the listener cancels. Fails with a sentence if the CT's geometry is invalid, if the CT
/// contains no body (nothing above -400 HU that is thicker than a couch) or no air, or if nearly all of it is one
/// structure.
Result<LabelMap> autoLabel(const CtVolume& ct, const Progress& progress);

}  // namespace insonate
