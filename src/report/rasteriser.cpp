#include "src/report/rasteriser.h"

#include <array>
#include <memory>

#include <QByteArray>
#include <QFontDatabase>
#include <QGuiApplication>
#include <QImage>
#include <QPainter>
#include <QSvgRenderer>

namespace cutis {
namespace {

// What Qt has to say about the machine is no concern of who asked for a plot.
void keepSilent(QtMsgType, const QMessageLogContext&, const QString&) {}

class Silence {
 public:
  Silence() : before_(qInstallMessageHandler(keepSilent)) {}
  ~Silence() { qInstallMessageHandler(before_); }
  Silence(const Silence&) = delete;
  Silence& operator=(const Silence&) = delete;

 private:
  QtMessageHandler before_;
};

// Fonts need an application; this one needs no display.
std::unique_ptr<QGuiApplication> makeApplication() {
  if (QCoreApplication::instance() != nullptr) return nullptr;  // the caller's own
  static char program[] = "cutis", option[] = "-platform", platform[] = "offscreen";
  static int count;
  static std::array<char*, 4> arguments;
  // An application takes out what it has understood; the next one needs it all again.
  count = 3;
  arguments = {program, option, platform, nullptr};
  return std::make_unique<QGuiApplication>(count, arguments.data());
}

const char* rasterise(const RasteriserJob& job) {
  const Silence silence;
  const auto application = makeApplication();
  if (qobject_cast<QGuiApplication*>(QCoreApplication::instance()) == nullptr)
    return "this program cannot draw PNG; write an .svg";
  const int font = QFontDatabase::addApplicationFontFromData(
      QByteArray(job.font, static_cast<qsizetype>(job.fontSize)));
  // Without it every letter would be an empty box.
  if (font < 0) return "the font of plots cannot be read; write an .svg";
  QSvgRenderer renderer(QByteArray::fromRawData(job.svg, static_cast<qsizetype>(job.svgSize)));
  if (!renderer.isValid()) return "the plot could not be drawn; write an .svg";
  QImage image(renderer.defaultSize() * job.scale, QImage::Format_RGB32);
  if (image.isNull()) return "there is not enough memory to draw the plot; write an .svg";
  image.fill(Qt::white);
  QPainter painter(&image);
  painter.setRenderHints(QPainter::Antialiasing | QPainter::TextAntialiasing);
  renderer.render(&painter);
  painter.end();
  QFontDatabase::removeApplicationFont(font);
  return image.save(QString::fromUtf8(job.path), "PNG")
             ? nullptr
             : "the picture cannot be written; make room or choose another folder";
}

}  // namespace
}  // namespace cutis

extern "C" Q_DECL_EXPORT const char* cutisRasterise(const cutis::RasteriserJob* job) {
  return cutis::rasterise(*job);
}
