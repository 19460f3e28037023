#include "Transport.h"

#include "../ReviewSession.h"
#include "../attempt/Words.h"

#include <insonate/ui/AttemptWords.h>
#include <insonate/ui/Commands.h>
#include <insonate/ui/StateColors.h>
#include <insonate/ui/Theme.h>

#include <QComboBox>
#include <QHBoxLayout>
#include <QLabel>
#include <QPushButton>
#include <QSignalBlocker>

namespace insonate::review {
namespace {

/// A smaller value is shown as 0.0.
constexpr double kFelt_N = 0.05;

}  // namespace

Transport::Transport(ReviewSession& session, const ui::Commands& commands, QWidget* parent)
    : QWidget(parent),
      session_(session),
      speed_(new QComboBox(this)),
      time_(new QLabel(this)),
      place_(new QLabel(this)),
      hands_(new QLabel(this)) {
  place_->setTextFormat(Qt::RichText);
  auto* row = new QHBoxLayout(this);
  row->setContentsMargins(ui::kGap, ui::kSmallGap, ui::kGap, ui::kSmallGap);
  row->setSpacing(ui::kGap);
  const auto tip = [&commands](const char* command) { return commands.toolTip(QLatin1String(command)); };
  auto* previous = add("previousMoment", "previous", tr("Previous marked moment"), tip("review.replay.previousMoment"));
  play_ = add("play", "play", tr("Play"), tip("review.replay.play"));
  auto* next = add("nextMoment", "next", tr("Next moment"), tip("review.replay.nextMoment"));
  for (QPushButton* button : {previous, play_, next}) row->addWidget(button);
  speed_->setObjectName(QStringLiteral("speed"));
  speed_->setAccessibleName(tr("Speed"));
  speed_->setToolTip(commands.toolTip(tr("Playback speed"), QStringLiteral("review.replay.speed")));
  for (const double speed : ReviewSession::kSpeeds) speed_->addItem(tr("%1 x").arg(speed));
  row->addWidget(speed_);
  time_->setObjectName(QStringLiteral("timeNow"));
  time_->setToolTip(tr("Playback position and duration of the attempt: minutes, seconds"));
  time_->setMinimumWidth(time_->fontMetrics().horizontalAdvance(QStringLiteral("00:00.00 / 00:00.00")) + ui::kGap);
  row->addWidget(time_);
  ui::setRole(place_, "heading");
  place_->setObjectName(QStringLiteral("needlePlace"));
  row->addWidget(place_);
  hands_->setObjectName(QStringLiteral("handsNow"));
  hands_->setToolTip(
      tr("Insertion length along the needle shaft, tip depth on the image's depth scale, and probe force"));
  // A growing sentence must not widen the window.
  hands_->setSizePolicy(QSizePolicy::Ignored, QSizePolicy::Preferred);
  row->addWidget(hands_, 1);
  connect(previous, &QPushButton::clicked, this, [this] { session_.stepMoment(-1); });
  connect(next, &QPushButton::clicked, this, [this] { session_.stepMoment(1); });
  connect(play_, &QPushButton::clicked, this, [this] { session_.setPlaying(!session_.isPlaying()); });
  connect(speed_, QOverload<int>::of(&QComboBox::activated), this,
          [this](int index) { session_.setSpeed(ReviewSession::kSpeeds[index]); });
  connect(&session_, &ReviewSession::playingChanged, this, [this] { showPlaying(); });
  connect(&session_, &ReviewSession::timeChanged, this, [this] { showTime(); });
  showPlaying();
  showTime();
}

QPushButton* Transport::add(const char* object, const char* icon, const QString& name, const QString& tip) {
  auto* button = new QPushButton(ui::icon(QLatin1String(icon)), {}, this);
  button->setObjectName(QLatin1String(object));
  button->setAccessibleName(name);
  button->setToolTip(tip);
  button->setFocusPolicy(Qt::TabFocus);
  return button;
}

void Transport::showPlaying() {
  const bool playing = session_.isPlaying();
  play_->setIcon(ui::icon(playing ? QStringLiteral("pause") : QStringLiteral("play")));
  play_->setText(playing ? tr("Stop") : tr("Play"));
  play_->setAccessibleName(play_->text());
  play_->setMinimumWidth(96);
  const QSignalBlocker quiet(speed_);
  for (int i = 0; i < int(std::size(ReviewSession::kSpeeds)); ++i)
    if (ReviewSession::kSpeeds[i] == session_.speed()) speed_->setCurrentIndex(i);
}

void Transport::showTime() {
  const std::int64_t end_us = session_.attempt() ? session_.attempt()->end_us : 0;
  time_->setText(QStringLiteral("%1 / %2").arg(clockOf(session_.time_us()), clockOf(end_us)));
  const auto& sample = session_.sample();
  const bool needle = sample && sample->patientFromNeedle;
  const AttemptDigest::PlaceChange now = session_.needle();
  const ui::PlaceWords place = ui::displayText(now.place, QString::fromStdString(now.vessel));
  place_->setText(needle ? QStringLiteral("<span style='color:%1'>%2</span> %3")
                               .arg(ui::toQColor(ui::colorOf(now.place)).name(), place.sign, place.words)
                         : QString());
  hands_->setText(handsNow());
}

QString Transport::handsNow() const {
  const auto& sample = session_.sample();
  if (!sample) return session_.attempt() ? tr("This part of the recording is missing.") : QString();
  QStringList words;
  if (sample->needleDepth_mm) words << tr("inserted %1\u00a0mm").arg(*sample->needleDepth_mm, 0, 'f', 1);
  if (sample->needleDepth_mm && sample->patientFromNeedle && sample->patientFromProbe) {
    const Vec3 tip_probe = inverted(*sample->patientFromProbe) * sample->patientFromNeedle->offset;
    words << tr("depth %1\u00a0mm").arg(tip_probe.z, 0, 'f', 1);
  }
  if (sample->aspirating) words << tr("aspirating");
  if (!sample->patientFromProbe) words << tr("no probe");
  if (sample->probeForce_N >= kFelt_N) words << tr("probe force %1 N").arg(sample->probeForce_N, 0, 'f', 1);
  return words.join(QStringLiteral("   "));
}

}  // namespace insonate::review
