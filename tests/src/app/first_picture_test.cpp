// A document shows a large picture before it is read, or while it is.

#include <filesystem>

#include <QSignalSpy>
#include <QtTest>

#include "src/app/document/document.h"
#include "tests/support/expect.h"
#include "tests/support/scratch_folder.h"
#include "tests/support/test_registry.h"

namespace cutis {
namespace {
namespace first_picture_test {

constexpr int kWidth = 2304;
constexpr int kHeight = 640;

class FirstPictureTest : public QObject {
  Q_OBJECT

 private slots:
  void init() {
    // Signals in the order in which they come.
    events_.clear();
    document_ = std::make_unique<Document>(engine_, jobs_);
    connect(document_.get(), &Document::previewed, this, [this](const SourcePreview& preview) {
      events_ << "previewed";
      first_ = preview;
    });
    connect(document_.get(), &Document::previewRefined, this, [this](const SourcePreview& preview) {
      events_ << "refined";
      last_ = preview;
    });
    connect(document_.get(), &Document::previewEnded, this, [this] { events_ << "ended"; });
    connect(document_.get(), &Document::opened, this, [this] { events_ << "opened"; });
    connect(document_.get(), &Document::failed, this, [this] { events_ << "failed"; });
  }
  void cleanup() {
    jobs_.stopAll();
    document_.reset();
  }

  void anOpenExrIsSeenBeforeItIsRead() {
    document_->open(writePicture("first.exr"));
    QTRY_VERIFY(document_->isOpen());
    QCOMPARE(events_.mid(0, 2), (QStringList{"previewed", "opened"}));
    QCOMPARE(first_.width, kWidth);
    QCOMPARE(first_.height, kHeight);
    QCOMPARE(first_.picture.width, kWidth / 2);
    QVERIFY(first_.picture.present.front() && first_.picture.present.back());
  }

  void aPngIsSeenWhileItIsRead() {
    document_->open(writePicture("rows.png"));
    QTRY_VERIFY(document_->isOpen());
    QCOMPARE(events_.mid(0, 2), (QStringList{"previewed", "refined"}));
    QCOMPARE(events_.count("previewed"), 1);
    QVERIFY(events_.indexOf("opened") > events_.lastIndexOf("refined"));
    QVERIFY(first_.picture.present.front() && !first_.picture.present.back());
    QVERIFY(last_.picture.present.front() && last_.picture.present.back());
  }

  void whatIsCutOffIsReportedOnce() {
    for (const char* name : {"cut.png", "cut.tif", "cut.exr"}) {
      const std::filesystem::path path = writePicture(name);
      std::filesystem::resize_file(path, std::filesystem::file_size(path) / 2);
      events_.clear();
      document_->open(path);
      QTRY_VERIFY(jobs_.isIdle() && !events_.isEmpty());
      QCOMPARE(events_.count("failed"), 1);
      QTRY_VERIFY(!document_->isPreviewed());
    }
  }

  // What is open stays in sight until there is something else.
  void nothingIsSeenBeforeWhatIsOpen() {
    const auto path = writePicture("again.exr");
    document_->open(path);
    QTRY_VERIFY(document_->isOpen());
    events_.clear();
    document_->open(path);
    QTRY_VERIFY(events_.contains("opened"));
    QVERIFY(!events_.contains("previewed"));
  }

 private:
  std::filesystem::path writePicture(const std::string& name) {
    const auto path = folder_ / name;
    const auto store = std::make_shared<TileStore>();
    ImageContent content;
    content.channelNames = {"R", "G", "B"};
    const std::vector<float> values(std::size_t{kWidth} * kHeight, 0.4f);
    for (int c = 0; c < 3; ++c) {
      content.channels.emplace_back(kWidth, kHeight, PixelFormat::float32, store);
      if (content.channels.back().store({0, 0, kWidth, kHeight}, values).failed()) return {};
    }
    const SampleType type = path.extension() == ".exr" ? SampleType::half : SampleType::uint8;
    return writeImage(path, content, type, {}).failed() ? std::filesystem::path() : path;
  }

  test::ScratchFolder folder_;
  Engine engine_{std::filesystem::path()};
  JobRunner jobs_;
  std::unique_ptr<Document> document_;
  QStringList events_;
  SourcePreview first_;
  SourcePreview last_;
};

CUTIS_TEST(FirstPictureTest)

}  // namespace first_picture_test
}  // namespace
}  // namespace cutis

#include "first_picture_test.moc"
