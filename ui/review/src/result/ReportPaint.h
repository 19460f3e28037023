#pragma once

#include "PlanePlot.h"

#include <QImage>
#include <QRectF>
#include <QString>

namespace insonate::review {

/// A page about one attempt, dark on white: facts, points and advice, what went wrong, all metrics, the tip's way in
/// the picture's plane and in 3D (`scene`; null for none). `page` is A4 upright, in whatever unit the painter has.
void paintReport(QPainter& painter, const QRectF& page, const AttemptDigest& attempt, const PlaneSection& section,
                 const QImage& scene);

/// Writes that page, as PDF where the file ends in .pdf, else as a PNG of 150 dots an inch; beside its place first, and
/// moved there. An empty string, or a sentence that says why not.
QString writeReport(const QString& file, const AttemptDigest& attempt, const PlaneSection& section,
                    const QImage& scene);

}  // namespace insonate::review
