//! MAT files against SciPy's, damaged ones, and the formats that are not read.

mod common;

use common::{Random, made};
use ident::record::{MatError, MatValue, Variable, read_mat};

fn read(name: &str) -> Vec<Variable> {
    read_mat(&std::fs::read(made(name)).unwrap()).unwrap()
}

fn matrix<'a>(variables: &'a [Variable], name: &str) -> (usize, usize, &'a [f64]) {
    match &variables.iter().find(|v| v.name == name).unwrap_or_else(|| panic!("no {name}")).value {
        MatValue::Matrix { rows, columns, values } => (*rows, *columns, values),
        other => panic!("{name} is {other:?}"),
    }
}

#[test]
fn every_class_of_numbers() {
    let data = [0.0, 0.25, 0.5, 0.75, 1.0, 0.0, 1.5, -2.0, 3.25, 0.125, 1.0, 2.0, 3.0, 4.0, 5.0];
    for name in ["level4.mat", "level5.mat", "level5_compressed.mat"] {
        let variables = read(name);
        assert_eq!(matrix(&variables, "double"), (5, 3, &data[..]), "{name}");
        assert_eq!(matrix(&variables, "single"), (5, 3, &data[..]), "{name}");
        assert_eq!(matrix(&variables, "uint8"), (1, 2, &[0.0, 255.0][..]), "{name}");
        assert_eq!(matrix(&variables, "int16"), (2, 1, &[-32768.0, 32767.0][..]), "{name}");
        assert_eq!(matrix(&variables, "uint16"), (1, 2, &[0.0, 65535.0][..]), "{name}");
        assert_eq!(matrix(&variables, "int32"), (1, 2, &[-2_147_483_648.0, 2_147_483_647.0][..]), "{name}");
    }
    for name in ["level5.mat", "level5_compressed.mat"] {
        let variables = read(name);
        assert_eq!(matrix(&variables, "int8"), (1, 3, &[-128.0, 0.0, 127.0][..]));
        assert_eq!(matrix(&variables, "uint32"), (1, 2, &[0.0, 4_294_967_295.0][..]));
        assert_eq!(matrix(&variables, "int64"), (1, 2, &[-9_007_199_254_740_992.0, 9_007_199_254_740_992.0][..]));
        assert_eq!(matrix(&variables, "uint64"), (1, 2, &[0.0, 9_007_199_254_740_992.0][..]));
        assert_eq!(matrix(&variables, "logical"), (1, 2, &[1.0, 0.0][..]));
        assert_eq!(matrix(&variables, "empty"), (0, 0, &[][..]));
    }
}

#[test]
fn what_is_no_matrix_of_numbers_is_named() {
    let kinds = |name: &str| {
        let others: Vec<String> = read(name)
            .into_iter()
            .filter_map(|v| if let MatValue::Other(kind) = v.value { Some(format!("{}: {kind}", v.name)) } else { None })
            .collect();
        others.join("; ")
    };
    assert_eq!(kinds("level4.mat"), "text: text; complex: a complex matrix");
    let five = "text: text; cell: a cell array; struct: a struct; complex: a complex matrix; cube: an array of more than two dimensions";
    assert_eq!(kinds("level5.mat"), five);
    assert_eq!(kinds("level5_compressed.mat"), five);
}

#[test]
fn big_endian_files() {
    // level 4, type 1000: one double 1.5 named `x`
    let words = [1000_u32, 1, 1, 0, 2];
    let mut bytes: Vec<u8> = words.iter().flat_map(|w| w.to_be_bytes()).collect();
    bytes.extend(b"x\0");
    bytes.extend(1.5_f64.to_be_bytes());
    assert_eq!(matrix(&read_mat(&bytes).unwrap(), "x"), (1, 1, &[1.5][..]));
    // level 5, `MI`: the same, with a small element for the name
    let mut bytes = vec![b' '; 124];
    bytes.extend([1, 0]);
    bytes.extend(b"MI");
    let tag = |kind: u32, length: u32| [kind.to_be_bytes(), length.to_be_bytes()].concat();
    bytes.extend(tag(14, 16 + 16 + 8 + 16));
    bytes.extend([tag(6, 8), tag(6, 0)].concat());
    bytes.extend([tag(5, 8), tag(1, 1)].concat());
    bytes.extend([(1_u32 << 16 | 1).to_be_bytes(), [b'x', 0, 0, 0]].concat());
    bytes.extend([tag(9, 8), 1.5_f64.to_be_bytes().to_vec()].concat());
    assert_eq!(matrix(&read_mat(&bytes).unwrap(), "x"), (1, 1, &[1.5][..]));
}

#[test]
fn what_is_not_read_says_what_to_do() {
    let message = |bytes: &[u8]| read_mat(bytes).unwrap_err().to_string();
    let mut hdf = vec![0; 512];
    hdf[..10].copy_from_slice(b"MATLAB 7.3");
    hdf.extend(b"\x89HDF\r\n\x1a\n");
    let text = message(&hdf);
    assert!(
        text.starts_with(
            "this is a MAT file of level 7.3 (HDF5), which is not read; in MATLAB save it anew: `load run.mat; save('run.mat', '-v7')`"
        ),
        "{text}"
    );
    assert_eq!(read_mat(b"\x89HDF\r\n\x1a\nxxxx"), Err(MatError::Level73));
    assert_eq!(message(b"t,theta\n0,1\n"), "this is no MAT file of level 4 or 5; a text file needs the ending `.csv` or `.txt`");
    assert_eq!(message(b""), "this is no MAT file of level 4 or 5; a text file needs the ending `.csv` or `.txt`");
    let cut = &std::fs::read(made("level4.mat")).unwrap()[..100];
    assert_eq!(message(cut), "the file ends inside of the variable `double` (5 x 3), which begins at byte 0; it was not copied completely");
    let cut = &std::fs::read(made("level5.mat")).unwrap()[..200];
    assert_eq!(message(cut), "the file ends inside of an element, which begins at byte 128; it was not copied completely");
}

#[test]
fn a_header_that_lies_allocates_nothing() {
    // 2^31 x 2^31 doubles, and no data
    let words = [0_u32, 1 << 31, 1 << 31, 0, 2];
    let mut bytes: Vec<u8> = words.iter().flat_map(|w| w.to_le_bytes()).collect();
    bytes.extend(b"x\0");
    assert!(matches!(read_mat(&bytes), Err(MatError::Truncated { .. })));
}

#[test]
fn damaged_files_never_panic() {
    let mut random = Random(20_240_711);
    let originals: Vec<Vec<u8>> =
        ["level4.mat", "level5.mat", "level5_compressed.mat", "run.mat"].iter().map(|n| std::fs::read(made(n)).unwrap()).collect();
    let (mut read, mut refused) = (0, 0);
    for k in 0..8000 {
        let mut bytes = originals[k % originals.len()].clone();
        random.mutate(&mut bytes);
        match read_mat(&bytes) {
            Ok(variables) => {
                read += 1;
                for v in variables {
                    if let MatValue::Matrix { rows, columns, values } = v.value {
                        assert_eq!(rows * columns, values.len());
                    }
                }
            }
            Err(e) => {
                refused += 1;
                assert!(!e.to_string().is_empty());
            }
        }
    }
    assert!(read > 500 && refused > 500, "{read} {refused}");
}
