#include "GuidePage.h"

#include "../model/LabelTerms.h"
#include "GuideSession.h"

#include <insonate/ui/LetterKeyFilter.h>
#include <insonate/ui/StateColors.h>
#include <insonate/ui/Theme.h>
#include <insonate/ui/ValueSlider.h>
#include <insonate/ui/Widgets.h>

#include <QEvent>
#include <QHBoxLayout>
#include <QHeaderView>
#include <QLabel>
#include <QPushButton>
#include <QResizeEvent>
#include <QScrollArea>
#include <QScrollBar>
#include <QShortcut>
#include <QSignalBlocker>
#include <QTreeWidget>
#include <QVBoxLayout>
#include <algorithm>

namespace insonate::prepare {
namespace {

constexpr int kListRows = 3, kWordsLines = 4;  // minimum numbers of rows and lines

/// A list with the height of its content at its width; it scrolls if the column is too low.
class WordsArea : public QScrollArea {
 public:
  explicit WordsArea(QWidget* content);

  QSize sizeHint() const override;

 protected:
  bool eventFilter(QObject* watched, QEvent* event) override;
  void resizeEvent(QResizeEvent* event) override;
};

WordsArea::WordsArea(QWidget* content) {
  setFrameShape(QFrame::NoFrame);
  setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
  setFocusPolicy(Qt::TabFocus);
  setSizePolicy(QSizePolicy::Preferred, QSizePolicy::Preferred);
  setWidgetResizable(true);
  setWidget(content);
  content->installEventFilter(this);
}

QSize WordsArea::sizeHint() const {
  const int width = viewport()->width();
  return {widget()->sizeHint().width(), widget()->heightForWidth(width)};
}

bool WordsArea::eventFilter(QObject* watched, QEvent* event) {
  if (watched == widget() && event->type() == QEvent::LayoutRequest) updateGeometry();
  return QScrollArea::eventFilter(watched, event);
}

void WordsArea::resizeEvent(QResizeEvent* event) {
  QScrollArea::resizeEvent(event);
  if (event->size().width() != event->oldSize().width()) updateGeometry();
}

QString wordOf(GuideSession::State state, bool optional) {
  switch (state) {
    case GuideSession::State::ToDo:
      return optional ? GuidePage::tr("optional") : GuidePage::tr("to do");
    case GuideSession::State::Working:
      return GuidePage::tr("running");
    case GuideSession::State::Done:
      return GuidePage::tr("done");
    case GuideSession::State::Warning:
      return GuidePage::tr("warning");
    case GuideSession::State::Skipped:
      return GuidePage::tr("skipped");
  }
  return {};
}

/// States how many clicks suffice, before the first.
QString firstWords(const GuideStep& step) {
  const auto most = std::ranges::max(step.ways, {}, &GuideMethod::minClicks).minClicks;
  const QString enough =
      most > step.minClicks
          ? GuidePage::tr("No clicks yet. %1 clicks are enough if the CT shows contrast agent, otherwise %2.")
                .arg(step.minClicks)
                .arg(most)
          : GuidePage::tr("No clicks yet. %1 clicks are enough, %2 if the structure is hard to see.")
                .arg(step.minClicks)
                .arg(step.clicks);
  return enough + GuidePage::tr(" Ctrl + wheel zooms, a double click enlarges a view, G hides the labels.");
}

/// States whether the clicks suffice, and how to complete them.
QString clicksWords(const GuideStep& step, int count, int needed) {
  if (count == 0) return firstWords(step);
  QStringList words;
  if (count < needed) words << GuidePage::tr("Clicks so far: %1; %2 more needed.").arg(count).arg(needed - count);
  if (count < needed && needed > step.minClicks) words << GuidePage::tr("The CT shows no contrast agent here.");
  if (count >= needed)
    words << (count < step.clicks
                  ? GuidePage::tr(
                        "Clicks so far: %1, which is enough. If the structure is hard to see, make %2 clicks.")
                        .arg(count)
                        .arg(step.clicks)
                  : GuidePage::tr("Clicks so far: %1, which is enough.").arg(count));
  words << GuidePage::tr("Drag a point to move it. A right click or Delete removes a point.");
  return words.join(QLatin1Char(' '));
}

}  // namespace

GuidePage::GuidePage(GuideSession& guide, QWidget* parent) : QWidget(parent), guide_(guide), list_(new QTreeWidget) {
  setObjectName(QStringLiteral("guide"));
  list_->setObjectName(QStringLiteral("guideSteps"));
  list_->setAccessibleName(tr("Labeling steps"));
  list_->setToolTip(tr("Labeling steps in order; select a step to repeat it"));
  new ui::LetterKeyFilter(list_);
  list_->setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
  list_->setColumnCount(2);
  list_->setHeaderHidden(true);
  list_->setRootIsDecorated(false);
  list_->setUniformRowHeights(true);
  list_->setTextElideMode(Qt::ElideMiddle);  // the side is at the end
  // The state of a step must be fully readable.
  list_->header()->setStretchLastSection(false);
  list_->header()->setSectionResizeMode(0, QHeaderView::Stretch);
  list_->header()->setSectionResizeMode(1, QHeaderView::ResizeToContents);
  for (const GuideStep& step : guide_.steps())
    new QTreeWidgetItem(list_, {QString::fromStdString(step.title), QString()});
  list_->setMinimumHeight(kListRows * list_->sizeHintForRow(0));
  auto* box = new QVBoxLayout(this);
  box->setContentsMargins(0, 0, 0, 0);
  box->setSpacing(ui::kGap);
  box->addWidget(list_, 1);
  box->addWidget(buildWords());
  box->addWidget(buildButtons());
  connect(list_, &QTreeWidget::currentItemChanged, this,
          [this](QTreeWidgetItem* item) { guide_.go(list_->indexOfTopLevelItem(item)); });
  connect(&guide_, &GuideSession::changed, this, &GuidePage::refresh);
  connect(&guide_, &GuideSession::clicksChanged, this, &GuidePage::refresh);
  connect(&guide_, &GuideSession::messageReported, this, [this](const QString& sentence) { told_->setText(sentence); });
  for (const int key : {Qt::Key_Return, Qt::Key_Enter}) {
    auto* enter = new QShortcut(key, this, nullptr, nullptr, Qt::WidgetWithChildrenShortcut);
    connect(enter, &QShortcut::activated, &guide_, &GuideSession::proceed);
  }
  refresh();
}

QWidget* GuidePage::buildWords() {
  title_ = ui::paragraph("guideTitle", "heading");
  say_ = ui::paragraph("guideSay");
  clicks_ = ui::paragraph("guideClicks", "quiet");
  result_ = ui::paragraph("guideResult");
  told_ = ui::paragraph("guideTold");
  auto* panel = new QWidget;
  auto* box = new QVBoxLayout(panel);
  box->setContentsMargins(0, 0, 0, 0);
  box->setSpacing(ui::kSmallGap);
  for (QLabel* label : {title_, say_, result_, told_, clicks_}) box->addWidget(label);
  box->addStretch(1);
  words_ = new WordsArea(panel);
  words_->setObjectName(QStringLiteral("guideWords"));
  words_->setAccessibleName(tr("Instructions for this step"));
  words_->setToolTip(tr("Instructions for this step, and its result"));
  words_->setMinimumHeight(kWordsLines * fontMetrics().lineSpacing());
  return words_;
}

QWidget* GuidePage::buildButtons() {
  const auto button = [](const char* name, const QString& text, const QString& tip) {
    auto* made = new QPushButton(text);
    made->setObjectName(QLatin1String(name));
    made->setToolTip(tip);
    return made;
  };
  run_ = button("guideRun", tr("Run"), {});
  accept_ = button("guideAccept", tr("Accept"), tr("Continues with the next step (Enter)"));
  correct_ = button("guideCorrect", tr("Edit result"),
                    tr("Lets you paint and erase this structure in the slices; other structures do not change"));
  correct_->setCheckable(true);
  skip_ = button("guideSkip", tr("Skip"), tr("Continues with the next step and leaves this structure unlabeled"));
  auto* radius = new ui::ValueSlider(tr("Brush"), tr("mm"), {0.5, 15, guide_.brush_mm(), 0.5, 1},
                                     tr("Radius of the spherical brush"));
  radius->setObjectName(QStringLiteral("guideBrush"));
  connect(radius, &ui::ValueSlider::valueChanged, &guide_, &GuideSession::setBrush);
  brush_ = new QWidget;
  auto* brushBox = new QVBoxLayout(brush_);
  brushBox->setContentsMargins(0, 0, 0, 0);
  QLabel* paints = ui::paragraph("guidePaints");
  paints->setText(tr("Drag in a slice to paint; hold Ctrl and drag to erase."));
  brushBox->addWidget(paints);
  brushBox->addWidget(radius);
  connect(run_, &QPushButton::clicked, this,
          [this] { guide_.state(guide_.current()) == GuideSession::State::Working ? guide_.cancel() : guide_.run(); });
  connect(accept_, &QPushButton::clicked, this, [this] {
    // The button is hidden, which would move the keyboard focus to the next widget.
    list_->setFocus();
    guide_.accept();
  });
  connect(correct_, &QPushButton::clicked, &guide_, &GuideSession::setCorrecting);
  connect(skip_, &QPushButton::clicked, &guide_, &GuideSession::skip);
  auto* panel = new QWidget;
  auto* box = new QVBoxLayout(panel);
  box->setContentsMargins(0, 0, 0, 0);
  box->setSpacing(ui::kSmallGap);
  box->addWidget(brush_);
  for (const auto& [left, right] : {std::pair{accept_, correct_}, {run_, skip_}}) {
    auto* row = new QHBoxLayout;
    row->setSpacing(ui::kSmallGap);
    row->addWidget(left);
    row->addWidget(right);
    box->addLayout(row);
  }
  return panel;
}

void GuidePage::showEvent(QShowEvent* event) {
  QWidget::showEvent(event);
  guide_.setShown(true);
}

void GuidePage::hideEvent(QHideEvent* event) {
  QWidget::hideEvent(event);
  guide_.setShown(false);
}

void GuidePage::refreshList() {
  const QSignalBlocker quiet(list_);
  for (int n = 0; n < list_->topLevelItemCount(); ++n) {
    const GuideStep& step = guide_.steps()[std::size_t(n)];
    const GuideSession::State state = guide_.state(n);
    QTreeWidgetItem* item = list_->topLevelItem(n);
    // The same word as in the list of structures.
    const auto labels = guide_.labelState(n);
    item->setText(1, labels ? stateWord(*labels) : wordOf(state, step.optional));
    item->setForeground(1, ui::toQColor(labels ? ui::colorOf(*labels) : ui::colorOf(state)));
    item->setData(0, Qt::AccessibleTextRole, item->text(0) + QStringLiteral(", ") + item->text(1));
  }
  list_->setCurrentItem(list_->topLevelItem(guide_.current()));
}

void GuidePage::refreshButtons() {
  const GuideSession::State state = guide_.state(guide_.current());
  const bool made = state == GuideSession::State::Done || state == GuideSession::State::Warning;
  const bool busy = guide_.isBusy();
  const bool working = state == GuideSession::State::Working;
  const bool proposes = guide_.proposesPlaces(guide_.current());
  run_->setText(proposes ? tr("Propose") : working ? tr("Cancel") : made ? tr("Repeat") : tr("Run"));
  run_->setToolTip(proposes                   ? tr("Proposes the places that are missing (Enter)")
                   : working                  ? tr("Cancels the step and restores the labels")
                   : guide_.step().clicks > 0 ? tr("Labels this structure from the clicks (Enter)")
                                              : tr("Labels these structures (Enter)"));
  run_->setEnabled((working && !proposes) || guide_.canRun());
  // One button for the next action.
  ui::setRole(run_, state == GuideSession::State::Done ? "" : "primary");
  ui::setRole(accept_, state == GuideSession::State::Done ? "primary" : "");
  accept_->setVisible(made);
  accept_->setEnabled(!busy && guide_.canAccept());
  correct_->setVisible(made && guide_.step().label != 0);
  correct_->setEnabled(!busy);
  correct_->setChecked(guide_.isCorrecting());
  skip_->setVisible(!made);
  skip_->setEnabled(!busy);
  brush_->setVisible(guide_.isCorrecting());
}

void GuidePage::refresh() {
  const GuideStep& step = guide_.step();
  const int index = guide_.current();
  const GuideSession::State state = guide_.state(index);
  const bool made = state == GuideSession::State::Done || state == GuideSession::State::Warning;
  refreshList();
  if (title_->text() != QString::fromStdString(step.title)) {
    told_->clear();
    words_->verticalScrollBar()->setValue(0);
  }
  title_->setText(QString::fromStdString(step.title));
  say_->setText(QString::fromStdString(made ? step.lookFor : step.instruction));
  clicks_->setVisible(step.clicks > 0 && !guide_.isCorrecting());
  if (step.clicks > 0) clicks_->setText(clicksWords(step, int(guide_.clicks_mm().size()), guide_.clicksNeeded()));
  const bool isWarning = state == GuideSession::State::Warning;
  QString result = guide_.remarks(index).join(QLatin1Char(' '));
  if (isWarning) result = tr("Warning: %1 %2").arg(result, QString::fromStdString(step.ifWrong));
  result_->setVisible(!result.isEmpty());
  result_->setText(result);
  const views::Color color = isWarning ? ui::colorOf(state) : views::theme::kText;
  result_->setStyleSheet(QStringLiteral("color: %1").arg(ui::toQColor(color).name()));
  if (state == GuideSession::State::Working) result_->hide();
  told_->setVisible(!told_->text().isEmpty());
  refreshButtons();
}

}  // namespace insonate::prepare
