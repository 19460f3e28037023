#pragma once

#include "PlanePlot.h"

#include <QImage>
#include <QString>

namespace insonate::review {

/// Writes a page about one attempt, dark on white: facts, points and advice, what went wrong, all metrics, the tip's
/// way in the image's plane and in 3D (`scene`; null for none). As writePage() does.
QString writeReport(const QString& file, const AttemptDigest& attempt, const PlaneSection& section,
                    const QImage& scene);

}  // namespace insonate::review
