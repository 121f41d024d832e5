#include "ui/dialogs/format_filters.h"

#include <QStringList>

#include "src/images/codec/image_formats.h"

namespace cutis {
namespace {

QString patternsOf(const ImageFormat& format) {
  QStringList patterns;
  for (const std::string_view extension : format.extensions)
    patterns << "*" + QString::fromLatin1(extension.data(), qsizetype(extension.size()));
  return patterns.join(' ');
}

}  // namespace

QString readableImagePatterns() {
  QStringList patterns;
  for (const ImageFormat& format : imageFormats())
    patterns << patternsOf(format);
  return patterns.join(' ');
}

QString writableImageFilters() {
  QStringList filters;
  for (const ImageFormat& format : imageFormats()) {
    const QString name = QString::fromLatin1(format.name.data(), qsizetype(format.name.size()));
    if (format.isWritten()) filters << QString("%1 (%2)").arg(name, patternsOf(format));
  }
  return filters.join(";;");
}

}  // namespace cutis
