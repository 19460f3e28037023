#pragma once

#include <insonate/cases/PatientCase.h>

namespace insonate {

/// Returns the distance along the body from the heart to the site of a case, positive toward the head, by the first
/// target, or else vessel, whose name is known: neck and chest 150 mm, abducted arm 120 mm, groin -350 mm. Without a
/// known name, the distance of the neck. Sources: modules/deformation/README.md.
double siteAboveHeart_mm(const CaseManifest& manifest);

}  // namespace insonate
