#include "CoursePage.h"

#include "HistoryPage.h"
#include "PathPage.h"
#include "QuestionnairePage.h"

#include <insonate/ui/Attempts.h>
#include <insonate/ui/Theme.h>

#include <QButtonGroup>
#include <QHBoxLayout>
#include <QKeyEvent>
#include <QPushButton>
#include <QStackedWidget>
#include <QToolButton>
#include <QVBoxLayout>

namespace insonate::train {

CoursePage::CoursePage(Course& course, LevelControl& levels, TestAdmissions& admissions, ui::Account* account,
                       const QString& leavingKeys, QWidget* parent)
    : QWidget(parent), tabs_(new QButtonGroup(this)), pages_(new QStackedWidget) {
  setObjectName(QStringLiteral("course"));
  auto* path = new PathPage(course, levels, admissions);
  auto* history = new HistoryPage(course, account);
  auto* questions = new QuestionnairePage(account, ui::formDraftsFolder());
  for (QWidget* page : {static_cast<QWidget*>(path), static_cast<QWidget*>(history), static_cast<QWidget*>(questions)})
    pages_->addWidget(page);
  auto* box = new QVBoxLayout(this);
  box->setContentsMargins(ui::kLargeGap, ui::kGap, ui::kLargeGap, ui::kGap);
  box->setSpacing(ui::kGap);
  box->addWidget(buildHead(leavingKeys));
  box->addWidget(pages_, 1);
  connect(path, &PathPage::chosen, this, &CoursePage::left);
  connect(history, &HistoryPage::attemptRequested, this, &CoursePage::attemptRequested);
  connect(history, &HistoryPage::messageReported, this, &CoursePage::messageReported);
  connect(history, &HistoryPage::written, this, &CoursePage::written);
  connect(history, &HistoryPage::failed, this, &CoursePage::failed);
  connect(questions, &QuestionnairePage::messageReported, this, &CoursePage::messageReported);
  showTab(Levels);
}

QWidget* CoursePage::buildHead(const QString& leavingKeys) {
  auto* head = new QWidget;
  auto* row = new QHBoxLayout(head);
  row->setContentsMargins(0, 0, 0, 0);
  const auto add = [&](Tab tab, const char* object, const QString& text, const QString& says) {
    auto* button = new QToolButton;
    button->setObjectName(QLatin1String(object));
    button->setText(text);
    button->setToolTip(tr("%1 (Alt+%2)").arg(says).arg(int(tab) + 1));
    button->setShortcut(QKeySequence(QStringLiteral("Alt+%1").arg(int(tab) + 1)));
    button->setCheckable(true);
    button->setFocusPolicy(Qt::TabFocus);
    ui::setRole(button, "narrowTab");
    tabs_->addButton(button, tab);
    row->addWidget(button);
  };
  add(Levels, "courseLevels", tr("Levels"),
      tr("Levels, each with its state (unlocked, mastered or locked) and the reason for it"));
  add(Attempts, "courseAttempts", tr("Your attempts"), tr("All your attempts, and the learning curve of a metric"));
  add(Questionnaire, "courseQuestionnaire", tr("Questionnaire"), tr("Your opinion of the simulator"));
  auto* back = new QPushButton(tr("Back to the image"));
  back->setObjectName(QStringLiteral("courseBack"));
  back->setToolTip(tr("Returns to probe, image and patient (%1, Esc)").arg(leavingKeys));
  row->addStretch(1);
  row->addWidget(back);
  connect(tabs_, &QButtonGroup::idClicked, this, [this](int tab) {
    showTab(Tab(tab));
    takeKeyboard();
  });
  connect(back, &QPushButton::clicked, this, &CoursePage::left);
  return head;
}

void CoursePage::showTab(Tab tab) {
  tabs_->button(tab)->setChecked(true);
  pages_->setCurrentIndex(tab);
}

void CoursePage::takeKeyboard() {
  QWidget* page = pages_->currentWidget();
  (page->focusProxy() ? page : tabs_->checkedButton())->setFocus(Qt::OtherFocusReason);
}

void CoursePage::keyPressEvent(QKeyEvent* event) {
  if (event->key() == Qt::Key_Escape) return Q_EMIT left();
  QWidget::keyPressEvent(event);
}

}  // namespace insonate::train
