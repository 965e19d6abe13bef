#include "studio/take/Hdf5.hpp"

#include <algorithm>
#include <array>
#include <cassert>
#include <charconv>
#include <utility>

namespace thinwall::hdf5 {
namespace {

// Strong enough to halve typical takes; the next levels cost several times as much for a few per cent.
constexpr unsigned kCompression = 1;

herr_t keep_innermost(unsigned depth, const H5E_error2_t* error, void* text) {
  if (depth == 0 && error->desc != nullptr) *static_cast<std::string*>(text) = error->desc;
  return 0;
}

/// What the library quotes of the operating system's answer: the text between `mark` and `end`.
std::string quoted(const std::string& description, const std::string& mark, char end) {
  const auto begin = description.find(mark);
  if (begin == std::string::npos) return "";
  return description.substr(begin + mark.size(), description.find(end, begin + mark.size()) - begin - mark.size());
}

[[noreturn]] void fail() {
  std::string description = "no reason given";
  H5Ewalk2(H5E_DEFAULT, H5E_WALK_UPWARD, keep_innermost, &description);
  const std::string code = quoted(description, "errno = ", ',');
  int number = 0;
  std::from_chars(code.data(), code.data() + code.size(), number);
  if (number == 0) throw Failure(description);
  throw Failure(quoted(description, "error message = '", '\''), number);
}

template <typename Result>
Result check(Result result) {
  if (result < 0) fail();
  return result;
}

/// The library prints each error and, at exit, tries again to write what a full disk refused; both are ours to handle.
void prepare_library() {
  static const bool prepared = [] {
    H5dont_atexit();
    H5open();
    H5Eset_auto2(H5E_DEFAULT, nullptr, nullptr);
    return true;
  }();
  static_cast<void>(prepared);
}

hid_t stored_type(Element element) {
  switch (element) {
    case Element::kFloat32:
      return H5T_IEEE_F32LE;
    case Element::kFloat64:
      return H5T_IEEE_F64LE;
    case Element::kUint32:
      return H5T_STD_U32LE;
  }
  return -1;
}

hid_t memory_type(Element element) {
  switch (element) {
    case Element::kFloat32:
      return H5T_NATIVE_FLOAT;
    case Element::kFloat64:
      return H5T_NATIVE_DOUBLE;
    case Element::kUint32:
      return H5T_NATIVE_UINT32;
  }
  return -1;
}

Handle text_type(std::size_t bytes) {
  Handle type(H5Tcopy(H5T_C_S1), H5Tclose);
  check(H5Tset_size(type.id(), bytes));
  check(H5Tset_cset(type.id(), H5T_CSET_UTF8));
  check(H5Tset_strpad(type.id(), H5T_STR_NULLPAD));
  return type;
}

Handle scalar_space() {
  return Handle(H5Screate(H5S_SCALAR), H5Sclose);
}

Handle dataset_properties(const std::vector<hsize_t>& chunk) {
  Handle properties(H5Pcreate(H5P_DATASET_CREATE), H5Pclose);
  check(H5Pset_obj_track_times(properties.id(), false));
  if (!chunk.empty()) {
    check(H5Pset_chunk(properties.id(), static_cast<int>(chunk.size()), chunk.data()));
    check(H5Pset_shuffle(properties.id()));
    check(H5Pset_deflate(properties.id(), kCompression));
    check(H5Pset_fletcher32(properties.id()));
  }
  return properties;
}

Handle create_dataset(const Handle& parent, const std::string& name, hid_t type, const Handle& space,
                      const Handle& properties) {
  return Handle(H5Dcreate2(parent.id(), name.c_str(), type, space.id(), H5P_DEFAULT, properties.id(), H5P_DEFAULT),
                H5Dclose);
}

void write_scalar_attribute(const Handle& object, const std::string& name, hid_t stored, hid_t memory,
                            const void* value) {
  if (check(H5Aexists(object.id(), name.c_str())) > 0) check(H5Adelete(object.id(), name.c_str()));
  const Handle space = scalar_space();
  const Handle attribute(H5Acreate2(object.id(), name.c_str(), stored, space.id(), H5P_DEFAULT, H5P_DEFAULT), H5Aclose);
  check(H5Awrite(attribute.id(), memory, value));
}

/// Throws Failure unless it holds one value: a reader has room for no more.
Handle open_attribute(const Handle& object, const std::string& name) {
  Handle attribute(H5Aopen(object.id(), name.c_str(), H5P_DEFAULT), H5Aclose);
  const Handle space(H5Aget_space(attribute.id()), H5Sclose);
  if (check(H5Sget_simple_extent_npoints(space.id())) != 1) throw Failure("attribute " + name + " is not one value");
  return attribute;
}

/// Throws Failure when the dataset says that it holds more than what is stored of it can give: a reader would make room
/// for all of it first.
void require_stored(const Handle& dataset, const std::string& name) {
  // Compression takes at most a little more than 1000 bytes into one; what is small does no harm.
  constexpr double kMostCompression = 1100;
  constexpr double kSmall = 16 << 20;  // bytes
  const Handle type(H5Dget_type(dataset.id()), H5Tclose);
  auto bytes = static_cast<double>(H5Tget_size(type.id()));
  for (const hsize_t extent : shape_of(dataset)) bytes *= static_cast<double>(extent);
  if (bytes <= kSmall + kMostCompression * static_cast<double>(H5Dget_storage_size(dataset.id()))) return;
  throw Failure(name + " says that it holds more than there is");
}

std::string without_padding(const char* text, std::size_t bytes) {
  return std::string(text, std::find(text, text + bytes, '\0'));
}

}  // namespace

Handle::Handle(hid_t id, Close closer) : id_(id), close_(closer) {
  if (id < 0) fail();
}

Handle::Handle(Handle&& other) noexcept : id_(std::exchange(other.id_, -1)), close_(other.close_) {}

Handle& Handle::operator=(Handle&& other) noexcept {
  std::swap(id_, other.id_);
  std::swap(close_, other.close_);
  return *this;
}

Handle::~Handle() {
  if (id_ >= 0) close_(id_);
}

void Handle::close() {
  if (id_ < 0) return;
  check(close_(std::exchange(id_, -1)));
}

Handle create_file(const std::filesystem::path& path) {
  prepare_library();
  const Handle creation(H5Pcreate(H5P_FILE_CREATE), H5Pclose);
  check(H5Pset_obj_track_times(creation.id(), false));
  check(H5Pset_link_creation_order(creation.id(), H5P_CRT_ORDER_TRACKED | H5P_CRT_ORDER_INDEXED));
  const Handle access(H5Pcreate(H5P_FILE_ACCESS), H5Pclose);
  // Closing the file then also closes what an exception left open in it.
  check(H5Pset_fclose_degree(access.id(), H5F_CLOSE_STRONG));
  return Handle(H5Fcreate(path.c_str(), H5F_ACC_TRUNC, creation.id(), access.id()), H5Fclose);
}

Handle open_file(const std::filesystem::path& path) {
  prepare_library();
  return Handle(H5Fopen(path.c_str(), H5F_ACC_RDONLY, H5P_DEFAULT), H5Fclose);
}

Handle create_group(const Handle& parent, const std::string& name) {
  const Handle creation(H5Pcreate(H5P_GROUP_CREATE), H5Pclose);
  check(H5Pset_obj_track_times(creation.id(), false));
  check(H5Pset_link_creation_order(creation.id(), H5P_CRT_ORDER_TRACKED | H5P_CRT_ORDER_INDEXED));
  return Handle(H5Gcreate2(parent.id(), name.c_str(), H5P_DEFAULT, creation.id(), H5P_DEFAULT), H5Gclose);
}

Handle open_group(const Handle& parent, const std::string& name) {
  return Handle(H5Gopen2(parent.id(), name.c_str(), H5P_DEFAULT), H5Gclose);
}

Handle open_dataset(const Handle& parent, const std::string& name) {
  Handle dataset(H5Dopen2(parent.id(), name.c_str(), H5P_DEFAULT), H5Dclose);
  require_stored(dataset, name);
  return dataset;
}

bool has_link(const Handle& parent, const std::string& name) {
  return check(H5Lexists(parent.id(), name.c_str(), H5P_DEFAULT)) > 0;
}

std::vector<std::string> link_names(const Handle& group) {
  H5G_info_t info;
  check(H5Gget_info(group.id(), &info));
  std::vector<std::string> names;
  for (hsize_t i = 0; i < info.nlinks; ++i) {
    const auto length =
        check(H5Lget_name_by_idx(group.id(), ".", H5_INDEX_CRT_ORDER, H5_ITER_INC, i, nullptr, 0, H5P_DEFAULT));
    std::string name(static_cast<std::size_t>(length), '\0');
    check(H5Lget_name_by_idx(group.id(), ".", H5_INDEX_CRT_ORDER, H5_ITER_INC, i, name.data(), name.size() + 1,
                             H5P_DEFAULT));
    names.push_back(std::move(name));
  }
  return names;
}

void write_attribute(const Handle& object, const std::string& name, const std::string& value) {
  // A type of no bytes does not exist; one padding byte reads as the empty text.
  const Handle type = text_type(std::max<std::size_t>(value.size(), 1));
  write_scalar_attribute(object, name, type.id(), type.id(), value.c_str());
}

void write_attribute(const Handle& object, const std::string& name, std::int64_t value) {
  write_scalar_attribute(object, name, H5T_STD_I64LE, H5T_NATIVE_INT64, &value);
}

void write_attribute(const Handle& object, const std::string& name, double value) {
  write_scalar_attribute(object, name, H5T_IEEE_F64LE, H5T_NATIVE_DOUBLE, &value);
}

std::string read_text_attribute(const Handle& object, const std::string& name) {
  const Handle attribute = open_attribute(object, name);
  const Handle type(H5Aget_type(attribute.id()), H5Tclose);
  if (H5Tget_class(type.id()) != H5T_STRING || H5Tis_variable_str(type.id()) > 0) {
    throw Failure("attribute " + name + " is not a text of fixed length");
  }
  std::vector<char> text(H5Tget_size(type.id()));
  const Handle memory = text_type(text.size());
  check(H5Aread(attribute.id(), memory.id(), text.data()));
  return without_padding(text.data(), text.size());
}

bool has_attribute(const Handle& object, const std::string& name) {
  return check(H5Aexists(object.id(), name.c_str())) > 0;
}

std::int64_t read_integer_attribute(const Handle& object, const std::string& name) {
  const Handle attribute = open_attribute(object, name);
  std::int64_t value = 0;
  check(H5Aread(attribute.id(), H5T_NATIVE_INT64, &value));
  return value;
}

double read_real_attribute(const Handle& object, const std::string& name) {
  const Handle attribute = open_attribute(object, name);
  double value = 0;
  check(H5Aread(attribute.id(), H5T_NATIVE_DOUBLE, &value));
  return value;
}

void write_array(const Handle& parent, const std::string& name, Element element, std::span<const hsize_t> shape,
                 const void* values) {
  const std::vector<hsize_t> extents(shape.begin(), shape.end());
  const bool empty = std::find(extents.begin(), extents.end(), hsize_t{0}) != extents.end();
  const Handle space(H5Screate_simple(static_cast<int>(extents.size()), extents.data(), nullptr), H5Sclose);
  const Handle dataset = create_dataset(parent, name, stored_type(element), space,
                                        dataset_properties(empty ? std::vector<hsize_t>{} : extents));
  if (!empty) check(H5Dwrite(dataset.id(), memory_type(element), H5S_ALL, H5S_ALL, H5P_DEFAULT, values));
}

void write_texts(const Handle& parent, const std::string& name, const std::vector<std::string>& texts) {
  std::size_t bytes = 1;
  for (const std::string& text : texts) bytes = std::max(bytes, text.size());
  std::vector<char> padded(bytes * texts.size(), '\0');
  for (std::size_t i = 0; i < texts.size(); ++i) {
    std::copy(texts[i].begin(), texts[i].end(), padded.begin() + static_cast<std::ptrdiff_t>(i * bytes));
  }
  const hsize_t count = texts.size();
  const Handle type = text_type(bytes);
  const Handle space(H5Screate_simple(1, &count, nullptr), H5Sclose);
  const Handle dataset = create_dataset(parent, name, type.id(), space, dataset_properties({}));
  if (count > 0) check(H5Dwrite(dataset.id(), type.id(), H5S_ALL, H5S_ALL, H5P_DEFAULT, padded.data()));
}

void write_text(const Handle& parent, const std::string& name, const std::string& text) {
  const Handle type = text_type(std::max<std::size_t>(text.size(), 1));
  const Handle dataset = create_dataset(parent, name, type.id(), scalar_space(), dataset_properties({}));
  check(H5Dwrite(dataset.id(), type.id(), H5S_ALL, H5S_ALL, H5P_DEFAULT, text.c_str()));
}

std::vector<hsize_t> shape_of(const Handle& dataset) {
  const Handle space(H5Dget_space(dataset.id()), H5Sclose);
  std::vector<hsize_t> shape(static_cast<std::size_t>(check(H5Sget_simple_extent_ndims(space.id()))));
  if (!shape.empty()) check(H5Sget_simple_extent_dims(space.id(), shape.data(), nullptr));
  return shape;
}

std::vector<std::string> read_texts(const Handle& parent, const std::string& name) {
  const Handle dataset = open_dataset(parent, name);
  const Handle type(H5Dget_type(dataset.id()), H5Tclose);
  if (H5Tget_class(type.id()) != H5T_STRING) throw Failure(name + " does not hold texts");
  return read_text_rows(dataset, H5Tget_size(type.id()));
}

std::string read_text(const Handle& parent, const std::string& name) {
  const std::vector<std::string> texts = read_texts(parent, name);
  if (texts.size() != 1) throw Failure(name + " is not one text");
  return texts.front();
}

std::vector<std::string> read_text_rows(const Handle& dataset, std::size_t bytes) {
  const std::vector<hsize_t> shape = shape_of(dataset);
  if (shape.size() > 1) throw Failure("texts stand in more than one dimension");
  const std::size_t count = shape.empty() ? 1 : shape.front();
  std::vector<char> padded(count * bytes);
  const Handle type = text_type(bytes);
  if (count > 0) check(H5Dread(dataset.id(), type.id(), H5S_ALL, H5S_ALL, H5P_DEFAULT, padded.data()));
  std::vector<std::string> texts;
  for (std::size_t i = 0; i < count; ++i) texts.push_back(without_padding(padded.data() + i * bytes, bytes));
  return texts;
}

void read_rows(const Handle& dataset, Element element, hsize_t first, hsize_t count, void* values) {
  std::vector<hsize_t> extents = shape_of(dataset);
  // Not as a sum, which a damaged file may let overflow.
  if (extents.empty() || first > extents.front() || count > extents.front() - first) {
    throw Failure("fewer rows than steps");
  }
  if (count == 0) return;
  std::vector<hsize_t> start(extents.size(), 0);
  start.front() = first;
  extents.front() = count;
  const Handle file_space(H5Dget_space(dataset.id()), H5Sclose);
  check(H5Sselect_hyperslab(file_space.id(), H5S_SELECT_SET, start.data(), nullptr, extents.data(), nullptr));
  const Handle memory_space(H5Screate_simple(static_cast<int>(extents.size()), extents.data(), nullptr), H5Sclose);
  check(H5Dread(dataset.id(), memory_type(element), memory_space.id(), file_space.id(), H5P_DEFAULT, values));
}

RowWriter::RowWriter(const Handle& parent, const std::string& name, Element element, std::vector<hsize_t> row_shape,
                     hsize_t rows_per_chunk)
    : type_(H5Tcopy(stored_type(element)), H5Tclose), row_shape_(std::move(row_shape)) {
  create(parent, name, rows_per_chunk);
}

RowWriter RowWriter::of_texts(const Handle& parent, const std::string& name, std::size_t bytes,
                              hsize_t rows_per_chunk) {
  RowWriter writer;
  writer.type_ = text_type(bytes);
  writer.create(parent, name, rows_per_chunk);
  return writer;
}

void RowWriter::create(const Handle& parent, const std::string& name, hsize_t rows_per_chunk) {
  std::vector<hsize_t> extents = {0};
  std::vector<hsize_t> limits = {H5S_UNLIMITED};
  std::vector<hsize_t> chunk = {rows_per_chunk};
  for (const hsize_t extent : row_shape_) {
    assert(extent > 0);
    extents.push_back(extent);
    limits.push_back(extent);
    chunk.push_back(extent);
  }
  const Handle space(H5Screate_simple(static_cast<int>(extents.size()), extents.data(), limits.data()), H5Sclose);
  dataset_ = create_dataset(parent, name, type_.id(), space, dataset_properties(chunk));
}

void RowWriter::append(const void* row) {
  std::vector<hsize_t> extents = {rows_ + 1};
  std::vector<hsize_t> start = {rows_};
  std::vector<hsize_t> count = {1};
  for (const hsize_t extent : row_shape_) {
    extents.push_back(extent);
    start.push_back(0);
    count.push_back(extent);
  }
  check(H5Dset_extent(dataset_.id(), extents.data()));
  const Handle file_space(H5Dget_space(dataset_.id()), H5Sclose);
  check(H5Sselect_hyperslab(file_space.id(), H5S_SELECT_SET, start.data(), nullptr, count.data(), nullptr));
  const Handle memory_space(H5Screate_simple(static_cast<int>(count.size()), count.data(), nullptr), H5Sclose);
  // This machine's numbers are little-endian as the stored ones are, so the stored type describes the memory too.
  check(H5Dwrite(dataset_.id(), type_.id(), memory_space.id(), file_space.id(), H5P_DEFAULT, row));
  ++rows_;
}

void flush(const Handle& file) {
  check(H5Fflush(file.id(), H5F_SCOPE_GLOBAL));
}

}  // namespace thinwall::hdf5
