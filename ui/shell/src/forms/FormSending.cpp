#include <insonate/ui/FormSending.h>

#include <QUuid>
#include <utility>

namespace insonate::ui {

FilledForm FormSending::identified(FilledForm filled) {
  filled.id = last_.id;
  if (filled.id.empty() || filled != last_)
    filled.id = QUuid::createUuid().toString(QUuid::WithoutBraces).toStdString();
  last_ = filled;
  return filled;
}

}  // namespace insonate::ui
