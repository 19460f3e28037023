#include "ReviewParts.h"

#include "attempt/Words.h"
#include "home/ReviewHome.h"
#include "judge/JudgeDesk.h"
#include "judge/JudgePane.h"
#include "list/AttemptList.h"
#include "replay/MomentList.h"
#include "replay/ReplayScene.h"
#include "replay/Timeline.h"
#include "replay/Transport.h"
#include "result/ReportPaint.h"
#include "result/ResultPage.h"

#include <insonate/cases/CaseVersions.h>
#include <insonate/ui/Attempts.h>
#include <insonate/ui/KnownCases.h>
#include <insonate/ui/PlainToolTip.h>
#include <insonate/ui/ScenePanel.h>
#include <insonate/ui/Theme.h>
#include <insonate/ui/ViewWidget.h>
#include <insonate/ui/Widgets.h>

#include <QAction>
#include <QButtonGroup>
#include <QDir>
#include <QFileDialog>
#include <QFileInfo>
#include <QLabel>
#include <QPushButton>
#include <QScrollArea>
#include <QSettings>
#include <QSplitter>
#include <QStackedLayout>
#include <QStackedWidget>
#include <QToolButton>
#include <QVBoxLayout>

namespace insonate::review {
namespace {

constexpr int kMoments_px = 270, kScene_px = 460;

}  // namespace

ReviewWorkspace::Parts::Parts(ReviewWorkspace& workspace, ui::TaskBar& taskBar)
    : tasks(taskBar),
      session(*new ReviewSession(&workspace)),
      judging(new JudgeDesk(session, this)),
      workspace_(workspace) {
  pages_ = new QStackedLayout(&workspace);
  pages_->setContentsMargins(0, 0, 0, 0);
  list = new AttemptList;
  home = new ReviewHome(*list);
  page_ = new QWidget;
  auto* box = new QVBoxLayout(page_);
  box->setContentsMargins(0, 0, 0, 0);
  box->setSpacing(0);
  notice_ = new QLabel;
  notice_->setObjectName(QStringLiteral("attemptNotice"));
  notice_->setWordWrap(true);
  notice_->setContentsMargins(ui::kGap, ui::kSmallGap, ui::kGap, ui::kSmallGap);
  ui::setRole(notice_, "problem");
  timeline_ = new Timeline(session);
  box->addWidget(buildBar());
  box->addWidget(notice_);
  box->addWidget(buildCentre(), 1);
  box->addWidget(new Transport(session));
  box->addWidget(timeline_);
  pages_->addWidget(home);
  pages_->addWidget(page_);
  connectParts();
  showTab(kResultTab);
  refreshReady();
}

ReviewWorkspace::Parts::~Parts() = default;

QWidget* ReviewWorkspace::Parts::buildBar() {
  auto* bar = new QFrame;
  ui::setRole(bar, "bar");
  auto* row = new QHBoxLayout(bar);
  row->setContentsMargins(ui::kGap, ui::kSmallGap, ui::kGap, ui::kSmallGap);
  row->setSpacing(ui::kGap);
  auto* back = new QPushButton(ui::icon(QStringLiteral("left")), tr("Attempts"));
  back->setObjectName(QStringLiteral("backToList"));
  back->setToolTip(tr("Returns to the list of attempts (Backspace)"));
  back->setFocusPolicy(Qt::TabFocus);
  connect(back, &QPushButton::clicked, this, [this] { session.close(); });
  row->addWidget(back);
  title_ = new QLabel;
  title_->setObjectName(QStringLiteral("attemptTitle"));
  ui::setRole(title_, "heading");
  facts_ = new QLabel;
  facts_->setObjectName(QStringLiteral("attemptFacts"));
  ui::setRole(facts_, "quiet");
  facts_->setSizePolicy(QSizePolicy::Ignored, QSizePolicy::Preferred);
  row->addWidget(title_);
  row->addWidget(facts_, 1);
  row->addWidget(buildTabs());
  return bar;
}

QWidget* ReviewWorkspace::Parts::buildTabs() {
  auto* tabs = new QWidget;
  auto* row = new QHBoxLayout(tabs);
  row->setContentsMargins(0, 0, 0, 0);
  row->setSpacing(0);
  tabs_ = new QButtonGroup(this);
  const auto addTab = [&](const char* object, const QString& text, const QString& tip) {
    auto* button = ui::tabButton(object, text, tip);
    row->addWidget(button);
    return button;
  };
  tabs_->addButton(addTab("replayTab", tr("Replay"), tr("The ultrasound image at each moment (1)")), kReplayTab);
  tabs_->addButton(addTab("resultTab", tr("Result"), tr("Points, metrics, and the needle's path (2)")), kResultTab);
  row->addSpacing(ui::kGap);
  look_ = addTab("sceneTab", tr("3D"), tr("Contents of the 3D view: structures, skin, clipping plane (3)"));
  judge_ = addTab("judgeTab", tr("Judge"), tr("Checklists and ratings of this attempt, in place of 3D (4)"));
  connect(look_, &QToolButton::toggled, this, [this] { showBelow(); });
  connect(judge_, &QToolButton::toggled, this, [this](bool judges) {
    // Judging refers to the replay.
    judges ? showTab(kReplayTab) : showBelow();
  });
  connect(tabs_, &QButtonGroup::idClicked, this, [this](int tab) { showTab(tab); });
  auto* save = new QAction(ui::icon(QStringLiteral("save")), tr("Save result ..."), &workspace_);
  save->setObjectName(QStringLiteral("saveResult"));
  save->setShortcut(QKeySequence(QStringLiteral("Ctrl+E")));
  save->setShortcutContext(Qt::WidgetWithChildrenShortcut);
  workspace_.addAction(save);
  connect(save, &QAction::triggered, this, [this] { exportResult(); });
  auto* button = new QPushButton(save->icon(), save->text());
  button->setToolTip(tr("Saves the result as a page, PDF or PNG (Ctrl+E)"));
  button->setFocusPolicy(Qt::TabFocus);
  connect(button, &QPushButton::clicked, save, &QAction::trigger);
  row->addSpacing(ui::kGap);
  row->addWidget(button);
  return tabs;
}

void ReviewWorkspace::Parts::showTab(int tab) {
  tabs_->button(tab)->setChecked(true);
  centre_->setCurrentIndex(tab);
  showBelow();
}

/// Under 3D: its settings or, with the result, the path of the needle. While the user judges, the forms replace it.
void ReviewWorkspace::Parts::showBelow() {
  right_->setCurrentIndex(judge_->isChecked() ? 1 : 0);
  scene_->panelArea().setVisible(look_->isChecked());
  path_->setVisible(centre_->currentIndex() == kResultTab && !look_->isChecked());
}

void ReviewWorkspace::Parts::exportResult() {
  if (!session.attempt()) return home->showSaving();
  const QString name = QFileInfo(QString::fromStdString(session.attempt()->file)).completeBaseName();
  const QString file = QFileDialog::getSaveFileName(&workspace_, tr("Save the result"),
                                                    QDir::home().filePath(name + QStringLiteral(".pdf")),
                                                    tr("PDF (*.pdf);;Image (*.png)"));
  if (!file.isEmpty()) saveResult(file);
}

void ReviewWorkspace::Parts::saveResult(const QString& file) {
  const QImage scene = session.fits() ? scene_->widget().grab().toImage() : QImage();
  const QString trouble = writeReport(file, *session.attempt(), path_->section(), scene);
  if (!trouble.isEmpty()) return Q_EMIT workspace_.failed(trouble, {}, {});
  Q_EMIT workspace_.written(tr("Result saved as %1.").arg(QFileInfo(file).fileName()), QFileInfo(file).absolutePath());
}

QWidget* ReviewWorkspace::Parts::buildCentre() {
  columns_ = new QSplitter(Qt::Horizontal);
  columns_->setObjectName(QStringLiteral("reviewColumns"));
  columns_->setChildrenCollapsible(false);
  auto* moments = new MomentList(session);
  moments->setMinimumWidth(kMoments_px * 3 / 4);
  picture_ = std::make_shared<views::UltrasoundView>();
  pictureWidget_ = new ui::ViewWidget(picture_, tr("Ultrasound image at that moment"));
  pictureWidget_->setObjectName(QStringLiteral("replayPicture"));
  scene_ = new ReplayScene(session, this);
  connect(moments, &MomentList::entered, this, [this] { showTab(kReplayTab); });
  columns_->addWidget(moments);
  centre_ = new QStackedWidget;
  centre_->addWidget(pictureWidget_);
  centre_->addWidget(new ResultPage(session));
  path_ = new PathPane(session);
  auto* right = new QSplitter(Qt::Vertical);
  right->setChildrenCollapsible(false);
  right->addWidget(&scene_->widget());
  right->addWidget(path_);
  right->addWidget(&scene_->panelArea());
  right->setSizes({600, 400, 400});
  auto* pane = new JudgePane(*judging, ui::formDraftsFolder());
  connect(pane, &JudgePane::said, &workspace_, [this](const QString& sentence) {
    said_ = sentence;
    Q_EMIT workspace_.statusChanged();
  });
  right_ = new QStackedWidget;
  right_->addWidget(right);
  right_->addWidget(pane);
  columns_->addWidget(centre_);
  columns_->addWidget(right_);
  columns_->setStretchFactor(0, 0);
  columns_->setStretchFactor(1, 3);
  columns_->setStretchFactor(2, 2);
  columns_->setSizes({kMoments_px, 700, kScene_px});
  ui::markViewRoom(columns_);
  for (QWidget* taker :
       std::initializer_list<QWidget*>{moments, pictureWidget_->focusProxy(), scene_->widget().focusProxy(), timeline_})
    taker->installEventFilter(&workspace_);
  return columns_;
}

void ReviewWorkspace::Parts::connectParts() {
  connect(list, &AttemptList::chosen, this, [this](const QString& file) { session.open(file, tasks); });
  connect(list, &AttemptList::listed, this, [this] { refreshReady(); });
  connect(home, &ReviewHome::replayWanted, this, [this](const QString& file, const QString& attempt) {
    judging->expect(file, attempt);
    session.open(file, tasks);
  });
  connect(judging, &JudgeDesk::changed, this, [this] {
    showNotice();
    refreshReady();
  });
  connect(judging, &JudgeDesk::failed, this,
          [this](const QString& what, const QString& advice) { Q_EMIT workspace_.failed(what, advice, {}); });
  connect(home, &ReviewHome::readinessChanged, this, [this] { refreshReady(); });
  connect(home, &ReviewHome::written, &workspace_, &ui::Workspace::written);
  connect(home, &ReviewHome::failed, this,
          [this](const QString& what, const QString& advice) { Q_EMIT workspace_.failed(what, advice, {}); });
  connect(&session, &ReviewSession::attemptChanged, this, [this] { showAttempt(); });
  connect(&session, &ReviewSession::openingChanged, this, [this] { refreshReady(); });
  connect(&session, &ReviewSession::caseChanged, this, [this] {
    QMetaObject::invokeMethod(
        this, [this] { openKeptVersion(); }, Qt::QueuedConnection);
    showNotice();
    refreshReady();
  });
  connect(&session, &ReviewSession::timeChanged, this, [this] {
    if (!said_.isEmpty()) said_.clear(), Q_EMIT workspace_.statusChanged();
    showPicture();
    refreshReady();
  });
  connect(&session, &ReviewSession::pictureShown, this, [this] {
    showPicture();
    refreshReady();
    Q_EMIT workspace_.statusChanged();
  });
  connect(&session, &ReviewSession::surfacesDone, this, [this] { refreshReady(); });
  connect(&session, &ReviewSession::messageChanged, this, [this] { Q_EMIT workspace_.statusChanged(); });
  connect(&session, &ReviewSession::failed, this,
          [this](const QString& what, const QString& advice) { Q_EMIT workspace_.failed(what, advice, {}); });
  scene_->setRested([this] { refreshReady(); });
}

void ReviewWorkspace::Parts::showAttempt() {
  pages_->setCurrentWidget(session.attempt() ? page_ : static_cast<QWidget*>(home));
  if (!session.attempt()) {
    list->refresh();
    return;
  }
  const AttemptRecording& recording = *session.attempt()->recording;
  title_->setText(titleOf(recording.header()));
  // The length is last: if it is cut off, it is also beside Play.
  facts_->setText(QStringList{QString::fromStdString(recording.header().caseName), wordsOf(recording.status()),
                              dateOf(recording.header().begun), clockOf(recording.end_us())}
                      .join(QStringLiteral("   ·   ")));
  facts_->setToolTip(ui::plainToolTip(facts_->text()));
  timeline_->setFocus();
  keptWanted_ = false;
  // Called once the session knows whether the case in the window is that of the attempt.
  QMetaObject::invokeMethod(
      this, [this] { findCase(); }, Qt::QueuedConnection);
}

/// Folder of the case's version on which an attempt was made; none if it was not kept.
std::optional<QString> ReviewWorkspace::Parts::keptVersion(const AttemptHeader& header) {
  const auto place = ui::placeOfCase(QString::fromStdString(header.caseName));
  const auto kept = place ? findVersion(place->toStdString(), header.caseHash) : std::nullopt;
  return kept ? std::optional(QString::fromStdString(kept->string())) : std::nullopt;
}

/// Asks once for each attempt: a user who keeps the open case is not asked again.
void ReviewWorkspace::Parts::openKeptVersion() {
  if (session.fit() != CaseFit::Changed || std::exchange(keptWanted_, true)) return;
  if (const auto kept = keptVersion(session.attempt()->recording->header())) Q_EMIT workspace_.caseWanted(*kept);
}

/// Searches the built-in and the recent cases by title.
void ReviewWorkspace::Parts::findCase() {
  if (!session.attempt() || (session.fit() != CaseFit::Missing && session.fit() != CaseFit::Other)) return;
  const QString title = QString::fromStdString(session.attempt()->recording->header().caseName);
  const auto kept = keptVersion(session.attempt()->recording->header());
  if (const auto place = kept ? kept : ui::placeOfCase(title)) return Q_EMIT workspace_.caseWanted(*place);
  Q_EMIT workspace_.failed(tr("The case '%1' of this attempt is not among the recent ones.").arg(title),
                           tr("Open it (Ctrl+O) to see hands and images; timeline and result do not need it."), {});
}

void ReviewWorkspace::Parts::showNotice() {
  QStringList lines;
  if (session.attempt())
    for (const std::string& trouble : session.attempt()->troubles) lines << QString::fromStdString(trouble);
  if (session.attempt() && (session.fit() == CaseFit::Other || session.fit() == CaseFit::Changed))
    lines.prepend(session.message());
  if (session.attempt() && session.fit() == CaseFit::Changed)
    if (const auto kept = keptVersion(session.attempt()->recording->header()))
      lines << tr("The attempt's version of the case is kept: open %1 (Ctrl+O) for its images.").arg(*kept);
  if (session.attempt() && judging->isOther()) lines.prepend(judging->words());
  notice_->setText(lines.join(QLatin1Char('\n')));
  notice_->setVisible(!lines.isEmpty());
}

/// Text shown instead of an image; empty if there is one.
QString ReviewWorkspace::Parts::pictureWords() const {
  if (!session.picture().trouble().isEmpty()) return session.picture().trouble();
  if (!session.sample()) return tr("This part of the recording is missing.");
  if (!session.sample()->patientFromProbe) return tr("The probe is not in the hand.");
  return session.picture().shown() ? QString() : tr("Rendering the image.");
}

void ReviewWorkspace::Parts::showPicture() {
  const auto& frame = session.picture().shown();
  picture_->setNotice(session.fits() ? pictureWords().toStdString() : std::string());
  if (frame == shown_) return;
  shown_ = frame;
  picture_->setImage(frame ? frame->image : BModeImage{});
}

void ReviewWorkspace::Parts::refreshReady() {
  const bool now = session.isSettled() && !judging->isReading() &&
                   (session.attempt() ? scene_->isAtRest() : !list->isReading() && home->isSettled());
  if (now == std::exchange(ready, now)) return;
  Q_EMIT workspace_.readyChanged();
}

void ReviewWorkspace::Parts::saveLayout(QSettings& settings) const {
  settings.setValue(QStringLiteral("columns"), columns_->saveState());
  settings.beginGroup(QStringLiteral("scene"));
  scene_->panel().save(settings);
  settings.endGroup();
}

void ReviewWorkspace::Parts::restoreLayout(QSettings& settings) {
  columns_->restoreState(settings.value(QStringLiteral("columns")).toByteArray());
  settings.beginGroup(QStringLiteral("scene"));
  scene_->panel().restore(settings);
  settings.endGroup();
}

}  // namespace insonate::review
