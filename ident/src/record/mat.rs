//! MATLAB's MAT files: which level a file is, and what a variable can be. Levels 4 and 5 are read here; 7.3 is HDF5.
//!
//! Nothing is believed: every length is checked against the bytes that are there before anything is allocated.

mod level4;
mod level5;

use std::fmt;

/// A variable of a MAT file.
#[derive(Clone, Debug, PartialEq)]
pub struct Variable {
    /// Name.
    pub name: String,
    /// What it holds.
    pub value: MatValue,
}

/// What a variable holds.
#[derive(Clone, Debug, PartialEq)]
pub enum MatValue {
    /// A real matrix, column-major.
    Matrix {
        /// Rows.
        rows: usize,
        /// Columns.
        columns: usize,
        /// rows x columns values, column after column.
        values: Vec<f64>,
    },
    /// Something else, in words: `a struct`.
    Other(&'static str),
}

/// Why a MAT file cannot be read.
#[derive(Clone, Debug, PartialEq)]
pub enum MatError {
    /// Level 7.3 is HDF5.
    Level73,
    /// Neither level 4 nor level 5.
    NotMat,
    /// The file ends inside something.
    Truncated {
        /// Inside of what: `variable data`.
        what: String,
        /// Byte at which that begins.
        offset: usize,
    },
    /// A header that cannot be right.
    Corrupt {
        /// What is wrong.
        why: String,
        /// Byte at which it begins; inside of a compressed variable, counted there.
        offset: usize,
    },
    /// A compressed variable cannot be unpacked.
    Inflate {
        /// Byte at which it begins.
        offset: usize,
    },
    /// A compressed variable unpacks to more than is allowed.
    TooLarge {
        /// Bytes that are allowed.
        limit: usize,
    },
}

impl fmt::Display for MatError {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::Level73 => f.write_str(
                "this is a MAT file of level 7.3 (HDF5), which is not read; in MATLAB save it anew: `load run.mat; save('run.mat', '-v7')`, \
                 or in Python: `scipy.io.savemat('run.mat', dict(h5py.File('old.mat')))` with each matrix transposed",
            ),
            Self::NotMat => f.write_str("this is no MAT file of level 4 or 5; a text file needs the ending `.csv` or `.txt`"),
            Self::Truncated { what, offset } => write!(f, "the file ends inside of {what}, which begins at byte {offset}; it was not copied completely"),
            Self::Corrupt { why, offset } => write!(f, "the file is damaged at byte {offset}: {why}"),
            Self::Inflate { offset } => write!(f, "the compressed variable at byte {offset} cannot be unpacked; the file is damaged"),
            Self::TooLarge { limit } => write!(f, "a compressed variable unpacks to more than {} MB", limit / 1_000_000),
        }
    }
}

impl std::error::Error for MatError {}

/// Reads all variables of a MAT file of level 4 or 5.
///
/// # Errors
/// [`MatError`]; no bytes make it panic.
pub fn read_mat(bytes: &[u8]) -> Result<Vec<Variable>, MatError> {
    const HDF5: &[u8] = b"\x89HDF\r\n\x1a\n";
    // MATLAB puts a block of 512 bytes of its own before the HDF5 signature
    if bytes.starts_with(HDF5) || bytes.get(512..).is_some_and(|b| b.starts_with(HDF5)) || bytes.starts_with(b"MATLAB 7.3") {
        return Err(MatError::Level73);
    }
    match bytes.get(126..128) {
        Some(b"IM") => level5::read(bytes, false),
        Some(b"MI") => level5::read(bytes, true),
        _ => level4::read(bytes),
    }
}

/// Numbers as they stand in a file.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
enum Number {
    I8,
    U8,
    I16,
    U16,
    I32,
    U32,
    I64,
    U64,
    F32,
    F64,
}

impl Number {
    fn size(self) -> usize {
        match self {
            Self::I8 | Self::U8 => 1,
            Self::I16 | Self::U16 => 2,
            Self::I32 | Self::U32 | Self::F32 => 4,
            Self::I64 | Self::U64 | Self::F64 => 8,
        }
    }

    /// All whole numbers of `bytes`.
    #[allow(clippy::cast_precision_loss)] // MATLAB's own conversion of 64-bit integers to double
    fn decode(self, bytes: &[u8], big: bool) -> Vec<f64> {
        macro_rules! all {
            ($type:ty, $convert:expr) => {
                bytes
                    .as_chunks::<{ size_of::<$type>() }>()
                    .0
                    .iter()
                    .map(|b| if big { <$type>::from_be_bytes(*b) } else { <$type>::from_le_bytes(*b) })
                    .map($convert)
                    .collect()
            };
        }
        match self {
            Self::I8 => all!(i8, f64::from),
            Self::U8 => all!(u8, f64::from),
            Self::I16 => all!(i16, f64::from),
            Self::U16 => all!(u16, f64::from),
            Self::I32 => all!(i32, f64::from),
            Self::U32 => all!(u32, f64::from),
            Self::I64 => all!(i64, |x| x as f64),
            Self::U64 => all!(u64, |x| x as f64),
            Self::F32 => all!(f32, f64::from),
            Self::F64 => all!(f64, |x| x),
        }
    }
}

/// Four bytes as a number.
fn word(bytes: &[u8], at: usize, big: bool) -> Option<u32> {
    let b: [u8; 4] = bytes.get(at..at.checked_add(4)?)?.try_into().ok()?;
    Some(if big { u32::from_be_bytes(b) } else { u32::from_le_bytes(b) })
}
