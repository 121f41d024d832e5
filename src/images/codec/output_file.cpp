#include "src/images/codec/output_file.h"

#include <algorithm>
#include <utility>

namespace cutis {

OutputFile::OutputFile(const std::filesystem::path& path)
    : IOProxy(path.string(), Write),
      stream_(path, std::ios::binary | std::ios::in | std::ios::out | std::ios::trunc),
      failed_(!stream_) {}

void OutputFile::insert(int64_t offset, std::string bytes) {
  insertAt_ = offset;
  inserted_ = std::move(bytes);
}

bool OutputFile::failed() const {
  const std::scoped_lock lock(mutex_);
  return failed_;
}

bool OutputFile::finish() {
  const std::scoped_lock lock(mutex_);
  stream_.close();
  failed_ = failed_ || !stream_;
  return !failed_;
}

size_t OutputFile::write(const void* bytes, size_t count) {
  const std::scoped_lock lock(mutex_);
  place(bytes, count, m_pos);
  m_pos += static_cast<int64_t>(count);
  return count;
}

size_t OutputFile::pwrite(const void* bytes, size_t count, int64_t offset) {
  const std::scoped_lock lock(mutex_);
  place(bytes, count, offset);
  return count;
}

size_t OutputFile::read(void* bytes, size_t count) {
  const std::scoped_lock lock(mutex_);
  stream_.clear();
  stream_.seekg(m_pos);
  stream_.read(static_cast<char*>(bytes), static_cast<std::streamsize>(count));
  const auto got = static_cast<size_t>(std::max<std::streamsize>(0, stream_.gcount()));
  stream_.clear();
  m_pos += static_cast<int64_t>(got);
  return got;
}

size_t OutputFile::size() const {
  const std::scoped_lock lock(mutex_);
  return static_cast<size_t>(end_);
}

void OutputFile::place(const void* bytes, size_t count, int64_t offset) {
  const int64_t before = std::clamp<int64_t>(insertAt_ - offset, 0, static_cast<int64_t>(count));
  const auto head = inserted_.empty() ? count : static_cast<size_t>(before);
  if (head > 0) store(bytes, head, offset);
  if (head == count) return;
  const auto length = static_cast<int64_t>(inserted_.size());
  store(inserted_.data(), inserted_.size(), insertAt_);
  store(static_cast<const char*>(bytes) + head, count - head,
        offset + static_cast<int64_t>(head) + length);
}

void OutputFile::store(const void* bytes, size_t count, int64_t offset) {
  end_ = std::max(end_, offset + static_cast<int64_t>(count));
  if (failed_) return;
  if (stream_.tellp() != offset) stream_.seekp(offset);
  stream_.write(static_cast<const char*>(bytes), static_cast<std::streamsize>(count));
  failed_ = !stream_;
}

}  // namespace cutis
