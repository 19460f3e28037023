#pragma once

#include "PlanePlot.h"

#include <QImage>
#include <QString>

namespace insonate::review {

/// Writes a page about one attempt, dark on white: facts, points and advice, errors, all metrics, and the tip's path in
/// the image plane and in 3D (`scene`; null: no 3D image). File and result as for writePage().
QString writeReport(const QString& file, const AttemptDigest& attempt, const PlaneSection& section,
                    const QImage& scene);

}  // namespace insonate::review
