#pragma once

#include "../attempt/AttemptDigest.h"
#include "NormBar.h"

#include <insonate/cases/PatientCase.h>

#include <QImage>
#include <QRectF>
#include <memory>

namespace insonate::review {

/// The section on which the tip's path in the plane of the image is drawn.
struct PlaneSection {
  std::int64_t time_us = 0;  ///< of the probe that it was cut with
  QRectF place_mm;           ///< lateral from left to right, depth downwards
  QImage structures;         ///< see-through but for vessels, bone, air and skin; null without a case
};

/// The plane of the image as the vein was first reached, else as the needle was deepest; an empty place where there
/// was no probe or no needle. Tissue is as in the CT, not as the probe pressed it. Some milliseconds.
PlaneSection sectionOf(const AttemptDigest& attempt, const PatientCase* patient);

/// The tip's way, lateral and deep, in the probe's frame, in millimeters at one scale for both; where it was outside
/// the image's slice, thin and dotted.
void paintPlane(QPainter& painter, const QRectF& place, const AttemptDigest& attempt, const PlaneSection& section,
                const ResultInk& ink);

}  // namespace insonate::review
