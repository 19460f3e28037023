#include "JudgePane.h"

#include "JudgeWords.h"
#include "JudgementTable.h"
#include "JudgingController.h"

#include <insonate/ui/FormSheet.h>
#include <insonate/ui/Theme.h>
#include <insonate/ui/Widgets.h>

#include <QButtonGroup>
#include <QComboBox>
#include <QHBoxLayout>
#include <QKeyEvent>
#include <QPushButton>
#include <QScrollArea>
#include <QSignalBlocker>
#include <QStackedWidget>
#include <QVBoxLayout>
#include <algorithm>
#include <utility>

namespace insonate::review {
namespace {

constexpr int kDraft_ms = 500;

std::vector<Form> formsOfRaters() {
  std::vector<Form> forms;
  for (const std::string& name : formPresetNames())
    if (auto form = loadForm(name); form && form->purpose != Form::Purpose::Questionnaire)
      forms.push_back(std::move(*form));
  return forms;
}

std::size_t itemCount(const Form& form) {
  std::size_t items = 0;
  for (const FormSection& section : form.sections) items += section.items.size();
  return items;
}

}  // namespace

JudgePane::JudgePane(JudgingController& controller, const QString& draftFolder, QWidget* parent)
    : QWidget(parent),
      controller_(controller),
      forms_(formsOfRaters()),
      draft_(std::make_shared<ui::FormDraft>(draftFolder)),
      tabs_(new QButtonGroup(this)),
      choice_(new QComboBox),
      words_(ui::paragraph("judgeWords", "quiet")),
      progress_(ui::paragraph("judgeProgress", "quiet")),
      pages_(new QStackedWidget),
      scroll_(new QScrollArea),
      handIn_(new QPushButton(tr("Hand in"))),
      confirm_(ui::pushButton("handInConfirm", tr("Hand in for good"),
                              tr("Stores the answers under your name; they cannot be changed afterward"))),
      cancel_(ui::pushButton("handInCancel", tr("Cancel"), tr("Returns to the form without handing it in"))),
      table_(new JudgementTable) {
  keeping_.setSingleShot(true);
  keeping_.setInterval(kDraft_ms);
  auto* box = new QVBoxLayout(this);
  box->setContentsMargins(ui::kGap, ui::kSmallGap, ui::kGap, ui::kGap);
  box->setSpacing(ui::kGap);
  box->addWidget(buildHead());
  box->addWidget(choice_);
  box->addWidget(words_);
  box->addWidget(pages_, 1);
  pages_->addWidget(buildSheet());
  pages_->addWidget(table_);
  connect(tabs_, &QButtonGroup::idClicked, this, [this](int page) { showPage(page); });
  connect(choice_, QOverload<int>::of(&QComboBox::currentIndexChanged), this, [this] {
    showSheet();
    showController();
  });
  connect(choice_, QOverload<int>::of(&QComboBox::activated), this, [this] { hasChosen_ = true; });
  connect(&keeping_, &QTimer::timeout, this, [this] { keepDraft(); });
  connect(handIn_, &QPushButton::clicked, this, [this] { askHandIn(); });
  connect(confirm_, &QPushButton::clicked, this, [this] { handIn(); });
  connect(cancel_, &QPushButton::clicked, this, [this] {
    closeQuestion();
    handIn_->setFocus();
  });
  connect(&controller_, &JudgingController::changed, this, [this] { showController(); });
  connect(&controller_, &JudgingController::handedIn, this, [this] { handedIn(); });
  connect(&controller_, &JudgingController::failed, this, [this] { handIn_->setEnabled(true); });
  showSheet();
  showController();
}

JudgePane::~JudgePane() {
  if (keeping_.isActive()) keepDraft();
}

QWidget* JudgePane::buildHead() {
  auto* head = new QWidget;
  auto* row = new QHBoxLayout(head);
  row->setContentsMargins(0, 0, 0, 0);
  row->setSpacing(0);
  addTab(*row, kFill, "fillForm", tr("Fill in"), tr("Judge this attempt"));
  addTab(*row, kRead, "readForms", tr("Handed in"), tr("Judgements of this attempt, and differences between raters"));
  row->addStretch(1);
  choice_->setObjectName(QStringLiteral("judgeForm"));
  choice_->setAccessibleName(tr("Form"));
  choice_->setToolTip(tr("The checklist or rating to fill in or to read"));
  choice_->setSizeAdjustPolicy(QComboBox::AdjustToMinimumContentsLengthWithIcon);
  for (const Form& one : forms_) choice_->addItem(QString::fromStdString(one.title));
  return head;
}

void JudgePane::addTab(QHBoxLayout& row, Page page, const char* object, const QString& text, const QString& tip) {
  auto* button = ui::tabButton(object, text, tip);
  tabs_->addButton(button, page);
  row.addWidget(button);
}

QWidget* JudgePane::buildSheet() {
  auto* part = new QWidget;
  auto* box = new QVBoxLayout(part);
  box->setContentsMargins(0, 0, 0, 0);
  box->setSpacing(ui::kGap);
  scroll_->setObjectName(QStringLiteral("judgeSheet"));
  scroll_->setWidgetResizable(true);
  scroll_->setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
  scroll_->setFrameShape(QFrame::NoFrame);
  scroll_->setFocusPolicy(Qt::NoFocus);
  handIn_->setObjectName(QStringLiteral("handIn"));
  ui::setRole(handIn_, "primary");
  auto* row = new QHBoxLayout;
  row->setSpacing(ui::kGap);
  for (QPushButton* one : {handIn_, confirm_, cancel_}) row->addWidget(one);
  row->addWidget(progress_, 1);
  box->addWidget(scroll_, 1);
  box->addLayout(row);
  return part;
}

const Form& JudgePane::form() const {
  return forms_[std::size_t(choice_->currentIndex())];
}

/// Chooses the form of which the metrics of the attempt answer more than half, such as the checklist of a whole line;
/// else the first form.
void JudgePane::chooseForm() {
  const auto& origin = controller_.origin();
  if (hasChosen_ || !origin || !origin->attempt) return;
  const auto isAnswered = [&](const Form& form) {
    return 2 * answersFrom(form, origin->attempt->metrics).size() > itemCount(form);
  };
  auto best = std::ranges::find_if(forms_, isAnswered);
  if (best == forms_.end()) best = forms_.begin();
  const QSignalBlocker block(choice_);
  choice_->setCurrentIndex(static_cast<int>(best - forms_.begin()));
}

FormAnswers JudgePane::proposal() const {
  const auto& origin = controller_.origin();
  const bool isOpen = origin && origin->attempt && controller_.mayJudge() && !controller_.hasHandedIn(form().name);
  return isOpen ? answersFrom(form(), origin->attempt->metrics) : FormAnswers{};
}

/// The selected form, with the answers so far.
void JudgePane::showSheet() {
  if (keeping_.isActive()) keepDraft();
  sheet_ = new ui::FormSheet(form());
  scroll_->setWidget(sheet_);  // deletes the former sheet
  subject_ = controller_.subject();
  if (!subject_.by.empty()) {
    const FormAnswers draft = draft_->read(subject_, form());
    sheet_->setAnswers(draft.empty() ? proposal() : draft);
    sheet_->showEvidence(proposal());
  }
  connect(sheet_, &ui::FormSheet::changed, &keeping_, qOverload<>(&QTimer::start));
  connect(sheet_, &ui::FormSheet::changed, this, [this] { closeQuestion(); });
  showHandIn();
}

void JudgePane::showController() {
  const auto& origin = controller_.origin();
  const bool readable = origin && origin->attempt;
  words_->setText(controller_.words());
  for (QWidget* one : std::initializer_list<QWidget*>{pages_, tabs_->button(kRead), choice_}) one->setVisible(readable);
  tabs_->button(kFill)->setVisible(controller_.mayJudge());
  showHandIn();
  if (controller_.isReading()) return;
  const bool isAnother = subject_ != controller_.subject();
  if (isAnother) chooseForm(), showSheet();
  const std::vector<StoredForm> forms = readable ? origin->forms : std::vector<StoredForm>();
  table_->show(form(), forms);
  const auto many = std::ranges::count_if(forms, [&](const StoredForm& one) { return one.filled.form == form().name; });
  tabs_->button(kRead)->setText(many > 0 ? tr("Handed in (%1)").arg(many) : tr("Handed in"));
  if (!controller_.mayJudge())
    showPage(kRead);
  else if (isAnother)
    showPage(kFill);
}

void JudgePane::showHandIn() {
  const bool done = controller_.hasHandedIn(form().name);
  handIn_->setEnabled(controller_.mayJudge() && !done);
  handIn_->setToolTip(
      done
          ? tr("You have handed in this form about this attempt; each form can be handed in only once")
          : tr("Asks for confirmation, then stores the answers under your name; the trainee can then read the answers, "
               "which cannot be changed"));
  closeQuestion();
}

void JudgePane::showPage(int page) {
  tabs_->button(page)->setChecked(true);
  pages_->setCurrentIndex(page);
}

void JudgePane::showProgress() {
  if (controller_.hasHandedIn(form().name))
    return progress_->setText(tr("You have handed in this form about this attempt. Your answers are under Handed in."));
  const FormAnswers answers = sheet_->answers();
  const FormScore score = formScore(form(), answers);
  if (!answers.empty() && answers == proposal())
    return progress_->setText(tr("Answers filled in from the metrics of the attempt, and marked so: %1 of %2. Check "
                                 "each one; answer the others yourself.")
                                  .arg(answers.size())
                                  .arg(itemCount(form())));
  if (answers.empty()) return progress_->setText(QString::fromStdString(form().about));
  const auto missing = std::ranges::count_if(checkAnswers(form(), answers),
                                             [&](const AnswerError& one) { return answers.count(one.item) == 0; });
  progress_->setText(missing > 0 ? tr("%1 required items have no answer yet. Draft saved.").arg(missing)
                                 : tr("All required items are answered: %1. Draft saved.").arg(scoreWords(score)));
}

void JudgePane::keepDraft() {
  keeping_.stop();
  if (!subject_.by.empty()) draft_->save(subject_, sheet_->form(), sheet_->answers());
}

/// Handing in is final, so that the first click only asks.
void JudgePane::askHandIn() {
  if (!sheet_->check())
    return Q_EMIT statusMessage(tr("Some answers cannot be stored; the errors are stated beside them."));
  handIn_->hide();
  confirm_->show();
  cancel_->show();
  cancel_->setFocus();
  progress_->setText(tr("Hand in %1? The answers cannot be changed afterward, and the trainee can read them.")
                         .arg(scoreWords(formScore(form(), sheet_->answers()))));
}

void JudgePane::closeQuestion() {
  confirm_->hide();
  cancel_->hide();
  handIn_->show();
  showProgress();
}

void JudgePane::handIn() {
  closeQuestion();
  keepDraft();
  handIn_->setEnabled(false);
  handing_ = {subject_, form()};
  // The draft is deleted when the store has confirmed, also if the user has signed out by then, so that no draft of a
  // stored form remains.
  controller_.handIn(form(), sheet_->answers(),
                     [draft = draft_, subject = subject_, form = form()] { draft->save(subject, form, {}); });
}

/// The user may have selected another form or attempt meanwhile.
void JudgePane::handedIn() {
  const auto& [subject, form] = handing_;
  Q_EMIT statusMessage(tr("The form is handed in. The trainee can now read it beside the attempt."));
  if (subject != subject_ || form.name != sheet_->form().name) return;
  sheet_->setAnswers({});
  keepDraft();
  showProgress();
  showPage(kRead);
}

void JudgePane::keyPressEvent(QKeyEvent* event) {
  if (event->key() != Qt::Key_Backspace) QWidget::keyPressEvent(event);
}

}  // namespace insonate::review
