#pragma once

#include <hdf5.h>

#include <cstdint>
#include <filesystem>
#include <span>
#include <stdexcept>
#include <string>
#include <vector>

/// The few things that takes need of the HDF5 library, with owned handles and exceptions. The library is not
/// thread-safe: one thread at a time.
namespace thinwall::hdf5 {

/// The library refused something; the message is the innermost reason that it gives.
class Failure : public std::runtime_error {
 public:
  explicit Failure(const std::string& reason, int code = 0) : std::runtime_error(reason), code_(code) {}
  /// Of the system (an errno value) when it was the system that refused, else 0.
  int code() const { return code_; }

 private:
  int code_;
};

/// An open file, group, dataset, ...: closed when it goes.
class Handle {
 public:
  using Close = herr_t (*)(hid_t);
  Handle() = default;
  /// Takes over what a library call returned. Throws Failure when that was an error.
  Handle(hid_t id, Close closer);
  Handle(Handle&& other) noexcept;
  Handle& operator=(Handle&& other) noexcept;
  ~Handle();

  hid_t id() const { return id_; }
  /// Closes now. Throws Failure when the library could not write what it still held.
  void close();

 private:
  hid_t id_ = -1;
  Close close_ = nullptr;
};

/// What an element of a dataset is.
enum class Element { kFloat32, kFloat64, kUint32 };

Handle create_file(const std::filesystem::path& path);
Handle open_file(const std::filesystem::path& path);
Handle create_group(const Handle& parent, const std::string& name);
Handle open_group(const Handle& parent, const std::string& name);
/// To read from. Throws Failure also where it says that it holds more than what is stored of it can give.
Handle open_dataset(const Handle& parent, const std::string& name);
bool has_link(const Handle& parent, const std::string& name);

/// Names of what a group holds, in the order in which it was created.
std::vector<std::string> link_names(const Handle& group);

void write_attribute(const Handle& object, const std::string& name, const std::string& value);
void write_attribute(const Handle& object, const std::string& name, std::int64_t value);
void write_attribute(const Handle& object, const std::string& name, double value);
bool has_attribute(const Handle& object, const std::string& name);
/// These throw Failure also where the attribute is not one value.
std::string read_text_attribute(const Handle& object, const std::string& name);
std::int64_t read_integer_attribute(const Handle& object, const std::string& name);
double read_real_attribute(const Handle& object, const std::string& name);

/// A dataset that is written at once. `shape` may contain zeros.
void write_array(const Handle& parent, const std::string& name, Element element, std::span<const hsize_t> shape,
                 const void* values);
void write_texts(const Handle& parent, const std::string& name, const std::vector<std::string>& texts);
void write_text(const Handle& parent, const std::string& name, const std::string& text);

std::vector<hsize_t> shape_of(const Handle& dataset);
std::vector<std::string> read_texts(const Handle& parent, const std::string& name);
std::string read_text(const Handle& parent, const std::string& name);

/// Reads `count` rows from `first` on into `values`, which must have room for them.
void read_rows(const Handle& dataset, Element element, hsize_t first, hsize_t count, void* values);

/// A dataset to which rows are added one by one, compressed and with check sums.
class RowWriter {
 public:
  RowWriter() = default;
  /// `row_shape` holds the extents of a row (none: one element); `rows_per_chunk` rows are stored together.
  RowWriter(const Handle& parent, const std::string& name, Element element, std::vector<hsize_t> row_shape,
            hsize_t rows_per_chunk);
  /// Rows are texts of at most `bytes` bytes.
  static RowWriter of_texts(const Handle& parent, const std::string& name, std::size_t bytes, hsize_t rows_per_chunk);

  void append(const void* row);
  const Handle& dataset() const { return dataset_; }

 private:
  void create(const Handle& parent, const std::string& name, hsize_t rows_per_chunk);

  Handle type_;
  std::vector<hsize_t> row_shape_;
  Handle dataset_;
  hsize_t rows_ = 0;
};

/// Rows of texts as RowWriter::of_texts wrote them.
std::vector<std::string> read_text_rows(const Handle& dataset, std::size_t bytes);

/// Hands what is written so far to the operating system.
void flush(const Handle& file);

}  // namespace thinwall::hdf5
