#include "ReportPaint.h"

#include "../attempt/Words.h"
#include "MetricTable.h"
#include "PaperPage.h"
#include "ResultPage.h"

#include <insonate/ui/AttemptWords.h>
#include <insonate/ui/Text.h>

#include <QPainter>
#include <algorithm>

namespace insonate::review {
namespace {

using namespace paper;

constexpr std::size_t kMaxMoments = 9;

class Page {
 public:
  Page(QPainter& painter, const AttemptDigest& attempt) : painter_(painter), attempt_(attempt), ink_(ui::paperInk()) {}

  void all(const PlaneSection& section, const QImage& scene) {
    head();
    verdict();
    const double tableTop = y_;
    metrics(QRectF(kMargin, tableTop, 1130, 0));
    const double left = kMargin + 1190, width = kWidth - kMargin - left;
    heading(QRectF(left, tableTop, width, kRow), tr("Needle tip in the image plane, mm"));
    QRectF plane(left, tableTop + kRow, width, 560);
    painter_.save();
    painter_.scale(kScreen, kScreen);
    painter_.setFont(paperFont(kSmall / kScreen));
    paintPlane(painter_, QRectF(plane.topLeft() / kScreen, plane.size() / kScreen), attempt_, section, ink_);
    painter_.restore();
    if (!scene.isNull()) {
      heading(QRectF(left, plane.bottom() + 20, width, kRow), tr("In 3D"));
      const QSizeF size = QSizeF(scene.size()).scaled(width, 560, Qt::KeepAspectRatio);
      painter_.drawImage(QRectF(QPointF(left, plane.bottom() + 20 + kRow), size), scene);
    }
    moments();
    foot();
  }

 private:
  void text(const QRectF& place, const QString& words, const QColor& color, int flags = Qt::AlignLeft) {
    painter_.setPen(color);
    painter_.drawText(place, flags | Qt::AlignVCenter, words);
  }
  void heading(const QRectF& place, const QString& words) {
    painter_.setFont(paperFont(kText, true));
    text(place, words, ink_.text);
  }
  /// As high as its content; moves down.
  void paragraph(double left, double width, const QString& words, const QColor& color) {
    const QRectF room(left, y_, width, 400);
    painter_.setPen(color);
    QRectF used;
    painter_.drawText(room, Qt::AlignLeft | Qt::AlignTop | Qt::TextWordWrap, words, &used);
    y_ += used.height() + 8;
  }
  void head();
  void verdict();
  void metrics(const QRectF& place);
  void moments();
  void foot();

  QPainter& painter_;
  const AttemptDigest& attempt_;
  ui::Ink ink_;
  double y_ = kMargin;
};

void Page::head() {
  const AttemptHeader& header = attempt_.recording->header();
  painter_.setFont(paperFont(kTitle, true));
  text(QRectF(kMargin, y_, kWidth - 2 * kMargin, 80), titleOf(header), ink_.text);
  y_ += 90;
  painter_.setFont(paperFont(kText));
  QStringList facts{QString::fromStdString(header.caseName), dateOf(header.begun),
                    tr("duration %1").arg(clockOf(attempt_.end_us)), displayText(attempt_.recording->status())};
  if (const QString hands = displayText(header.hands); !hands.isEmpty()) facts << hands;
  text(QRectF(kMargin, y_, kWidth - 2 * kMargin, kRow), facts.join(QStringLiteral("   ·   ")), ink_.quiet);
  y_ += 60;
  painter_.setPen(QPen(ink_.line, 3));
  painter_.drawLine(QPointF(kMargin, y_), QPointF(kWidth - kMargin, y_));
  y_ += 30;
}

void Page::verdict() {
  const double left = kMargin + 280, width = kWidth - kMargin - left, top = y_;
  painter_.setFont(paperFont(170, true));
  text(QRectF(kMargin, top, 260, 190), pointsOf(attempt_), ink_.text);
  painter_.setFont(paperFont(kText));
  paragraph(left, width, pointsNoteOf(attempt_), ink_.quiet);
  if (attempt_.score) {
    painter_.setFont(paperFont(kText, true));
    paragraph(left, width, QString::fromStdString(attempt_.score->advice), ink_.text);
    painter_.setFont(paperFont(kText));
    for (const AttemptMoment& moment : attempt_.score->criticalErrors)
      paragraph(left, width,
                QStringLiteral("▲ %1  %2").arg(clockOf(moment.time_us), QString::fromStdString(moment.description)),
                ink_.danger);
  }
  for (const std::string& error : attempt_.errors) paragraph(left, width, QString::fromStdString(error), ink_.caution);
  y_ = std::max(y_, top + 210) + 20;
}

void Page::metrics(const QRectF& place) {
  heading(QRectF(place.left(), y_, 500, kRow), tr("Metrics"));
  painter_.setFont(paperFont(kSmall));
  const double value = place.left() + 500, novice = value + 160, bar = novice + 150, expert = bar + 220;
  const auto row = [&](const QString& v, const QString& n, const QString& e, const QColor& shade) {
    text(QRectF(value - 40, y_, 180, kRow), v, shade, Qt::AlignRight);
    text(QRectF(novice, y_, 130, kRow), n, ink_.quiet, Qt::AlignRight);
    text(QRectF(expert, y_, 130, kRow), e, ink_.quiet);
  };
  row(tr("value"), tr("novice"), tr("expert"), ink_.quiet);
  y_ += kRow;
  if (!attempt_.score) return;
  std::vector<MetricScore> scores = ordered(attempt_.score->metrics);
  // A page has room for the metrics of a puncture, or for those of a line and those with published values.
  if (std::ranges::any_of(scores, [](const MetricScore& one) { return isOfLine(one.metric); }))
    std::erase_if(scores, [](const MetricScore& one) { return !isOfLine(one.metric) && !one.norm; });
  for (const MetricScore& score : scores) {
    text(QRectF(place.left(), y_, 470, kRow), ui::titleOf(score.metric), ink_.text);
    const auto norm = [&](double number) { return normOf(score.metric, number); };
    row(ui::valueOf(score.metric, score.value), score.norm ? norm(score.norm->novice) : tr("n/a"),
        score.norm ? norm(score.norm->expert) : tr("n/a"), score.value ? ink_.text : ink_.quiet);
    painter_.save();
    painter_.scale(kScreen, kScreen);
    paintNormBar(painter_, QRectF(bar / kScreen, y_ / kScreen, 200 / kScreen, kRow / kScreen), score, ink_);
    painter_.restore();
    y_ += kRow;
  }
}

void Page::moments() {
  y_ += 30;
  heading(QRectF(kMargin, y_, 900, kRow), tr("Key moments"));
  y_ += kRow + 6;
  painter_.setFont(paperFont(kSmall));
  // If there is no room for all moments, errors come first.
  std::vector<AttemptMoment> told = attempt_.moments;
  std::ranges::stable_partition(told, [](const AttemptMoment& one) { return one.severity.has_value(); });
  const std::size_t count = std::min(told.size(), kMaxMoments);
  std::sort(told.begin(), told.begin() + std::ptrdiff_t(count),
            [](const auto& a, const auto& b) { return a.time_us < b.time_us; });
  for (std::size_t i = 0; i < count && y_ < kHeight - kMargin - 2 * kRow; ++i) {
    const QColor shade = !told[i].severity                      ? ink_.text
                         : *told[i].severity == Severity::Minor ? ink_.accent
                         : *told[i].severity == Severity::Major ? ink_.caution
                                                                : ink_.danger;
    const QString grade = told[i].severity ? tr(" (%1)").arg(ui::nameOf(*told[i].severity)) : QString();
    paragraph(
        kMargin, kWidth - 2 * kMargin,
        QStringLiteral("%1   %2%3").arg(clockOf(told[i].time_us), QString::fromStdString(told[i].description), grade),
        shade);
  }
  if (count < told.size())
    paragraph(kMargin, kWidth - 2 * kMargin, tr("and %1 more").arg(told.size() - count), ink_.quiet);
}

void Page::foot() {
  painter_.setFont(paperFont(kSmall));
  text(QRectF(kMargin, kHeight - kMargin, kWidth - 2 * kMargin, 40),
       tr("%1. For training; points are not a measure of competence.")
           .arg(QString::fromStdString(attempt_.recording->header().software)),
       ink_.quiet);
}

}  // namespace

QString writeReport(const QString& file, const AttemptDigest& attempt, const PlaneSection& section,
                    const QImage& scene) {
  return writePage(file, titleOf(attempt.recording->header()),
                   [&](QPainter& onPaper) { Page(onPaper, attempt).all(section, scene); });
}

}  // namespace insonate::review
