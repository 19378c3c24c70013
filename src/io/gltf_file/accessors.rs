//! Numbers of a glTF file, every access checked against the bytes that are there.

use gltf::Accessor;
use gltf::accessor::sparse::IndexType;
use gltf::accessor::{DataType, Dimensions};
use gltf::buffer::View;

use super::buffers::{Buffer, in_item};
use crate::io::ReadMeshError;
use crate::io::binary_cursor::{ByteOrder, Scalar};
use crate::io::mesh_draft::FilePosition;

/// Reads accessors out of loaded buffers.
pub(super) struct Accessors<'a> {
    pub(super) buffers: &'a [Buffer<'a>],
}

/// Values one stride apart.
struct Strided<'a> {
    bytes: &'a [u8],
    stride: usize,
}

/// Whether all numbers are zero because nothing backs them.
pub(super) fn all_zero(accessor: &Accessor<'_>) -> bool {
    accessor.view().is_none() && accessor.sparse().is_none()
}

impl Accessors<'_> {
    /// Points or displacements: `VEC3`, of floats or, as KHR_mesh_quantization allows, of whole numbers.
    pub(super) fn vectors(&self, accessor: &Accessor<'_>) -> Result<Vec<[f64; 3]>, ReadMeshError> {
        if accessor.dimensions() != Dimensions::Vec3 {
            return Err(self.error(accessor, "positions must be VEC3"));
        }
        let values = self.values(accessor, 3)?;
        Ok(values.chunks_exact(3).map(|v| [v[0], v[1], v[2]]).collect())
    }

    /// One number each, normalised where the file says so.
    pub(super) fn scalars(&self, accessor: &Accessor<'_>) -> Result<Vec<f64>, ReadMeshError> {
        if accessor.dimensions() != Dimensions::Scalar {
            return Err(self.error(accessor, "must be SCALAR"));
        }
        let values = self.values(accessor, 1)?;
        if let Some(at) = values.iter().position(|value| !value.is_finite()) {
            return Err(self.error(accessor, &format!("value {at} is not a finite number")));
        }
        Ok(values)
    }

    /// An error about an accessor, at its first byte where that is in the file as it stands.
    pub(super) fn error(&self, accessor: &Accessor<'_>, reason: &str) -> ReadMeshError {
        let item = format!("accessors[{}]", accessor.index());
        let start = accessor.view().and_then(|view| {
            let buffer = self.buffers.get(view.buffer().index())?;
            let offset = view.offset().saturating_add(accessor.offset());
            Some(buffer.start? + offset.min(buffer.bytes.len()))
        });
        match start {
            Some(byte) => FilePosition::Byte(byte).error(format!("{item}: {reason}")),
            None => in_item(item, reason),
        }
    }

    fn values(&self, accessor: &Accessor<'_>, width: usize) -> Result<Vec<f64>, ReadMeshError> {
        let scalar = scalar(accessor.data_type());
        let size = width * scalar.size();
        let count = accessor.count();
        let mut values = match accessor.view() {
            Some(view) => {
                let strided = self
                    .strided(&view, accessor.offset(), count, size)
                    .map_err(|reason| self.error(accessor, &reason))?;
                let mut values = Vec::with_capacity(count * width);
                for at in 0..count {
                    let bytes = &strided.bytes[at * strided.stride..];
                    values
                        .extend((0..width).map(|k| {
                            scalar.number(&bytes[k * scalar.size()..], ByteOrder::Little)
                        }));
                }
                values
            }
            // zeros by the specification, perhaps with a few values replaced; whoever asks has checked the count
            None => vec![0.0; count.saturating_mul(width)],
        };
        self.replace_sparse(accessor, &mut values, width)?;
        if accessor.normalized() {
            let greatest = match accessor.data_type() {
                DataType::I8 => 127.0,
                DataType::U8 => 255.0,
                DataType::I16 => 32_767.0,
                DataType::U16 => 65_535.0,
                DataType::U32 | DataType::F32 => 1.0,
            };
            for value in &mut values {
                *value = (*value / greatest).max(-1.0);
            }
        }
        Ok(values)
    }

    fn replace_sparse(
        &self,
        accessor: &Accessor<'_>,
        values: &mut [f64],
        width: usize,
    ) -> Result<(), ReadMeshError> {
        let Some(sparse) = accessor.sparse() else {
            return Ok(());
        };
        let scalar = scalar(accessor.data_type());
        let index = match sparse.indices().index_type() {
            IndexType::U8 => Scalar::U8,
            IndexType::U16 => Scalar::U16,
            IndexType::U32 => Scalar::U32,
        };
        let (indices, replacements) = (sparse.indices(), sparse.values());
        let (count, size) = (sparse.count(), width * scalar.size());
        let error = |reason: String| self.error(accessor, &reason);
        let indices = self
            .strided(&indices.view(), indices.offset(), count, index.size())
            .map_err(error)?;
        let replacements = self
            .strided(&replacements.view(), replacements.offset(), count, size)
            .map_err(error)?;
        for at in 0..count {
            let bytes = &indices.bytes[at * indices.stride..];
            let target = index.number(bytes, ByteOrder::Little) as usize;
            let slots = values.get_mut(target * width..(target + 1) * width);
            let slots = slots.ok_or_else(|| {
                error(format!(
                    "a sparse index of {target} in {} values",
                    accessor.count()
                ))
            })?;
            let bytes = &replacements.bytes[at * replacements.stride..];
            for (k, slot) in slots.iter_mut().enumerate() {
                *slot = scalar.number(&bytes[k * scalar.size()..], ByteOrder::Little);
            }
        }
        Ok(())
    }

    /// `count` values of `size` bytes from `offset` in a view, all of them there.
    fn strided(
        &self,
        view: &View<'_>,
        offset: usize,
        count: usize,
        size: usize,
    ) -> Result<Strided<'_>, String> {
        let stride = view.stride().unwrap_or(size);
        if stride < size {
            return Err(format!("values of {size} bytes, only {stride} apart"));
        }
        let needed = count
            .checked_sub(1)
            .and_then(|gaps| gaps.checked_mul(stride)?.checked_add(size))
            .unwrap_or(if count == 0 { 0 } else { usize::MAX });
        let bytes = self
            .buffers
            .get(view.buffer().index())
            .and_then(|buffer| buffer.bytes.get(view.offset()..))
            .and_then(|bytes| bytes.get(..view.length()))
            .and_then(|bytes| bytes.get(offset..))
            .filter(|bytes| bytes.len() >= needed)
            .ok_or_else(|| {
                format!(
                    "needs {needed} bytes from byte {offset} of bufferViews[{}], which has {} in a \
                     buffer of {}",
                    view.index(),
                    view.length(),
                    self.buffers
                        .get(view.buffer().index())
                        .map_or(0, |b| b.bytes.len())
                )
            })?;
        Ok(Strided { bytes, stride })
    }
}

fn scalar(data_type: DataType) -> Scalar {
    match data_type {
        DataType::I8 => Scalar::I8,
        DataType::U8 => Scalar::U8,
        DataType::I16 => Scalar::I16,
        DataType::U16 => Scalar::U16,
        DataType::U32 => Scalar::U32,
        DataType::F32 => Scalar::F32,
    }
}
