#include <insonate/ui/Theme.h>
#include <insonate/ui/Widgets.h>

namespace insonate::ui {

QLabel* paragraph(const char* object, const char* role, const QString& words) {
  auto* label = new QLabel(words);
  label->setObjectName(QLatin1String(object));
  label->setTextFormat(Qt::PlainText);
  label->setWordWrap(true);
  if (*role) setRole(label, role);
  return label;
}

QLabel* heading(const QString& words) {
  auto* label = new QLabel(words);
  setRole(label, "heading");
  return label;
}

QPushButton* pushButton(const char* object, const QString& words, const QString& tip, Qt::FocusPolicy focus) {
  auto* made = named(new QPushButton(words), object, {}, tip);
  made->setFocusPolicy(focus);
  made->setAutoDefault(false);
  return made;
}

QToolButton* tabButton(const char* object, const QString& words, const QString& tip) {
  auto* made = named(new QToolButton, object, {}, tip);
  made->setText(words);
  made->setCheckable(true);
  made->setFocusPolicy(Qt::TabFocus);
  setRole(made, "narrowTab");
  return made;
}

QComboBox* choiceBox(const char* object, const QString& name, const QString& tip, Qt::FocusPolicy focus) {
  auto* made = named(new QComboBox, object, name, tip);
  made->setSizeAdjustPolicy(QComboBox::AdjustToMinimumContentsLengthWithIcon);
  made->setFocusPolicy(focus);
  return made;
}

}  // namespace insonate::ui
