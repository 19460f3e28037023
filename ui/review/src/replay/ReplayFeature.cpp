#include "ReplayFeature.h"

#include "../ReviewSession.h"
#include "../page/AttemptPage.h"
#include "MomentList.h"
#include "Timeline.h"
#include "Transport.h"

#include <insonate/ui/ViewWidget.h>
#include <insonate/ui/Workspace.h>
#include <insonate/ultrasound/BeamGrid.h>

#include <algorithm>
#include <iterator>

namespace insonate::review {
namespace {

constexpr double kImage_s = 1.0 / 30;

}  // namespace

ReplayFeature::ReplayFeature(const ReviewModel& model, AttemptPage& page)
    : Feature(model),
      page_(page),
      view_(std::make_shared<views::UltrasoundView>()),
      image_(new ui::ViewWidget(view_, tr("Ultrasound image at the moment shown"))),
      timeline_(new Timeline(model.session)) {
  addCommands();
  image_->setObjectName(QStringLiteral("replayPicture"));
  auto* moments = new MomentList(model_.session);
  page_.addCenter(QStringLiteral("review.replay.show"), "replayTab", tr("Replay"), image_);
  page_.addLeft(moments);
  page_.addFoot(new Transport(model_.session, model_.workspace.commands()));
  page_.addFoot(timeline_);
  for (QWidget* one : std::initializer_list<QWidget*>{moments, image_->focusProxy(), timeline_}) passKeysOf(*one);
  connect(moments, &MomentList::entered, this, [this] { showImage(); });
  connect(&model_.session, &ReviewSession::attemptChanged, this, [this] {
    if (model_.session.attempt()) timeline_->setFocus();
  });
  connect(&model_.session, &ReviewSession::timeChanged, this, [this] { showFrame(); });
  connect(&model_.session, &ReviewSession::pictureShown, this, [this] { showFrame(); });
}

void ReplayFeature::showImage() {
  page_.showCenter(image_);
}

void ReplayFeature::addCommands() {
  ReviewSession& session = model_.session;
  model_.workspace.commands().beginSection(tr("Replay"));
  addForAttempt({.id = QStringLiteral("review.replay.show"),
                 .text = tr("Replay"),
                 .does = tr("shows the ultrasound image at each moment"),
                 .listed = tr("1"),
                 .keys = {{Qt::Key_1}},
                 .perform = [this](ui::KeyPress) { showImage(); }});
  addForAttempt({.id = QStringLiteral("review.replay.play"),
                 .text = tr("Play"),
                 .does = tr("plays or stops the replay"),
                 .listed = tr("Space"),
                 .keys = {{Qt::Key_Space}},
                 .perform = [&session](ui::KeyPress) { session.setPlaying(!session.isPlaying()); }});
  addTimeCommands();
  addForAttempt({.id = QStringLiteral("review.replay.speed"),
                 .text = {},
                 .does = tr("slows down or speeds up the replay"),
                 .listed = tr("-, +"),
                 .keys = {{Qt::Key_Minus, {}, [this](ui::KeyPress) { changeSpeed(-1); }},
                          {Qt::Key_Plus, {}, [this](ui::KeyPress) { changeSpeed(1); }},
                          {Qt::Key_Equal, {}, [this](ui::KeyPress) { changeSpeed(1); }}},
                 .perform = {}});
  model_.workspace.commands().addListed(tr("Click, drag on the timeline"),
                                        tr("goes to the clicked time, or to the time of the clicked mark"));
  model_.workspace.commands().addListed(tr("Wheel on the timeline"),
                                        tr("zooms the timeline; with Shift: scrolls the timeline"));
  model_.workspace.commands().addListed(tr("Double click on the timeline"),
                                        tr("shows the whole attempt on the timeline"));
}

void ReplayFeature::addTimeCommands() {
  ReviewSession& session = model_.session;
  const auto step = [&session](double seconds, double wide_s) {
    return [&session, seconds, wide_s](ui::KeyPress press) {
      session.setPlaying(false);
      session.step(press.wide ? wide_s : seconds);
    };
  };
  addForAttempt(
      {.id = QStringLiteral("review.replay.image"),
       .text = {},
       .does = tr("goes to the previous or next image (1/30 s)"),
       .listed = tr("Comma, Period"),
       .keys = {{Qt::Key_Comma, {}, step(-kImage_s, -kImage_s)}, {Qt::Key_Period, {}, step(kImage_s, kImage_s)}},
       .perform = {}});
  addForAttempt({.id = QStringLiteral("review.replay.second"),
                 .text = {},
                 .does = tr("goes back or forward by one second (with Shift: 10 seconds)"),
                 .listed = tr("Left, Right"),
                 .keys = {{Qt::Key_Left, {}, step(-1, -10)}, {Qt::Key_Right, {}, step(1, 10)}},
                 .perform = {}});
  addForAttempt({.id = QStringLiteral("review.replay.previousMoment"),
                 .text = tr("Previous marked moment"),
                 .does = tr("goes to the previous marked moment"),
                 .listed = tr("Page Up"),
                 .keys = {{Qt::Key_PageUp}},
                 .perform = [&session](ui::KeyPress) { session.stepMoment(-1); }});
  addForAttempt({.id = QStringLiteral("review.replay.nextMoment"),
                 .text = tr("Next moment"),
                 .does = tr("goes to the next marked moment"),
                 .listed = tr("Page Down"),
                 .keys = {{Qt::Key_PageDown}},
                 .perform = [&session](ui::KeyPress) { session.stepMoment(1); }});
  addForAttempt({.id = QStringLiteral("review.replay.ends"),
                 .text = {},
                 .does = tr("goes to the beginning or the end of the attempt"),
                 .listed = tr("Home, End"),
                 .keys = {{Qt::Key_Home, {}, [&session](ui::KeyPress) { session.setTime(0); }},
                          {Qt::Key_End, {}, [&session](ui::KeyPress) { session.setTime(session.attempt()->end_us); }}},
                 .perform = {}});
}

void ReplayFeature::changeSpeed(int by) {
  constexpr auto& kSpeeds = ReviewSession::kSpeeds;
  const auto* at = std::ranges::find(kSpeeds, model_.session.speed());
  model_.session.setSpeed(
      kSpeeds[std::clamp<std::ptrdiff_t>(at - std::begin(kSpeeds) + by, 0, std::ssize(kSpeeds) - 1)]);
}

/// Text shown instead of an image; empty if there is one.
QString ReplayFeature::imageWords() const {
  const ReviewSession& session = model_.session;
  const ReplayImage& picture = model_.session.picture();
  if (!picture.error().isEmpty()) return picture.error();
  if (!session.sample()) return tr("This part of the recording is missing.");
  if (!session.sample()->patientFromProbe) return tr("No hand holds the probe at this moment.");
  return picture.shown() ? QString() : tr("The image is being rendered.");
}

/// The image may be wider than the field of view; scale and marker are at the edges of the field of view.
void ReplayFeature::showFieldOfView(const LiveFrame& frame) {
  const BeamGrid grid(frame.setup->probe, frame.setup->settings);
  view_->setBounds(
      views::ImageBounds{grid.minLateral_mm(), grid.maxLateral_mm(), grid.minAxial_mm(), grid.maxAxial_mm()});
}

void ReplayFeature::showFrame() {
  const auto& frame = model_.session.picture().shown();
  view_->setNotice(model_.session.fits() ? imageWords().toStdString() : std::string());
  view_->setStaleMark(model_.session.isImageStale() ? tr("Image of another moment").toStdString() : std::string());
  if (frame == shown_) return;
  shown_ = frame;
  view_->setImage(frame ? frame->image : BModeImage{});
  view_->setColor(frame ? frame->color : ColorImage{});
  if (frame) showFieldOfView(*frame);
  view_->setLateral(frame ? std::optional(frame->patientFromProbe.linear.column[0]) : std::nullopt);
}

}  // namespace insonate::review
