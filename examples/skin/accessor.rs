//! What lies in the buffers of a file, every place checked.

use gltf::accessor::sparse::IndexType;
use gltf::accessor::{DataType, Dimensions};
use gltf::buffer::View;

/// The elements of an accessor, `N` numbers each, normalized where it says so.
pub(crate) fn read<const N: usize>(
    buffers: &[Vec<u8>],
    accessor: &gltf::Accessor<'_>,
    dimensions: Dimensions,
) -> Result<Vec<[f64; N]>, String> {
    let place = format!("accessor {}", accessor.index());
    let fail = |what: String| format!("{place}: {what}");
    if accessor.dimensions() != dimensions {
        return Err(fail(format!("{:?}, not {dimensions:?}", accessor.dimensions())));
    }
    let (data, count) = (accessor.data_type(), accessor.count());
    let size = N * width(data);
    let mut elements = match accessor.view() {
        // Nothing else holds memory against a count that a file merely claims.
        None if count > 1 << 24 => return Err(fail(format!("{count} elements of nothing"))),
        None => vec![[0.0; N]; count],
        Some(view) => {
            let stride = view.stride().unwrap_or(size);
            let bytes = slice(buffers, &view, accessor.offset(), count, stride, size, &place)?;
            let chunks = bytes.chunks(stride.max(1)).take(count);
            chunks.map(|chunk| element(chunk, data, accessor.normalized())).collect()
        }
    };
    if let Some(sparse) = accessor.sparse() {
        let (count, indices, values) = (sparse.count(), sparse.indices(), sparse.values());
        let index_type = match indices.index_type() {
            IndexType::U8 => DataType::U8,
            IndexType::U16 => DataType::U16,
            IndexType::U32 => DataType::U32,
        };
        let wide = width(index_type);
        let at = slice(buffers, &indices.view(), indices.offset(), count, wide, wide, &place)?;
        let new = slice(buffers, &values.view(), values.offset(), count, size, size, &place)?;
        for (at, new) in at.chunks(wide).zip(new.chunks(size)).take(count) {
            let index = number(at, index_type, false) as usize;
            let slot = elements
                .get_mut(index)
                .ok_or_else(|| fail(format!("sparse element {index} of {}", accessor.count())))?;
            *slot = element(new, data, accessor.normalized());
        }
    }
    if let Some(index) = elements.iter().position(|e| e.iter().any(|c| !c.is_finite())) {
        return Err(fail(format!("element {index} is {:?}", elements[index])));
    }
    Ok(elements)
}

/// The bytes of `count` elements.
fn slice<'b>(
    buffers: &'b [Vec<u8>],
    view: &View<'_>,
    offset: usize,
    count: usize,
    stride: usize,
    size: usize,
    place: &str,
) -> Result<&'b [u8], String> {
    let short = || format!("{place}: it ends beyond view {}", view.index());
    let length = match count.checked_sub(1) {
        None => 0,
        Some(last) => {
            last.checked_mul(stride).and_then(|n| n.checked_add(size)).ok_or_else(short)?
        }
    };
    let end = offset.checked_add(length).filter(|&end| end <= view.length()).ok_or_else(short)?;
    let buffer = buffers.get(view.buffer().index());
    let whole = view.offset().checked_add(view.length());
    let bytes = buffer.and_then(|buffer| buffer.get(view.offset()..whole?));
    let beyond = || format!("{place}: view {} ends beyond its buffer", view.index());
    Ok(&bytes.ok_or_else(beyond)?[offset..end])
}

fn width(data: DataType) -> usize {
    match data {
        DataType::I8 | DataType::U8 => 1,
        DataType::I16 | DataType::U16 => 2,
        DataType::U32 | DataType::F32 => 4,
    }
}

fn element<const N: usize>(bytes: &[u8], data: DataType, normalized: bool) -> [f64; N] {
    let mut numbers = bytes.chunks(width(data));
    [(); N].map(|()| numbers.next().map_or(0.0, |bytes| number(bytes, data, normalized)))
}

/// Integers are divided by the largest where they are normalized (glTF 2.0, §3.11).
pub(crate) fn number(bytes: &[u8], data: DataType, normalized: bool) -> f64 {
    let byte = |i: usize| bytes.get(i).copied().unwrap_or(0);
    let (two, four) = ([byte(0), byte(1)], [byte(0), byte(1), byte(2), byte(3)]);
    let (value, largest) = match data {
        DataType::I8 => (f64::from(byte(0).cast_signed()), 127.0),
        DataType::U8 => (f64::from(byte(0)), 255.0),
        DataType::I16 => (f64::from(i16::from_le_bytes(two)), 32767.0),
        DataType::U16 => (f64::from(u16::from_le_bytes(two)), 65535.0),
        DataType::U32 => (f64::from(u32::from_le_bytes(four)), 4_294_967_295.0),
        DataType::F32 => return f32::from_le_bytes(four).into(),
    };
    if normalized { (value / largest).max(-1.0) } else { value }
}
