#pragma once

#include "../attempt/AttemptDigest.h"
#include "NormBar.h"

#include <insonate/cases/PatientCase.h>

#include <QImage>
#include <QRectF>
#include <memory>

namespace insonate::review {

/// The section through the patient on which the tip's path in the image plane is drawn.
struct PlaneSection {
  std::int64_t time_us = 0;  ///< time of the probe pose that defines the section
  QRectF place_mm;           ///< rectangle of the section: lateral from left to right, depth downward
  QImage structures;         ///< image of the structures: vessels, bone, air and skin; transparent elsewhere; null
                             ///< without a case
};

/// Computes the section in the image plane at the time when the vein was first reached, else when the needle was
/// deepest. `place_mm` is empty if there was no probe or no needle. Tissue is shown as in the CT, without compression.
/// Takes some milliseconds.
PlaneSection sectionOf(const AttemptDigest& attempt, const PatientCase* patient);

/// Paints the path of the tip, lateral and depth in the probe's frame in mm, at the same scale for both. Parts outside
/// the image's slice thickness are thin and dotted.
void paintPlane(QPainter& painter, const QRectF& place, const AttemptDigest& attempt, const PlaneSection& section,
                const ui::Ink& ink);

}  // namespace insonate::review
