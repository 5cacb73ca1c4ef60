//! No input makes a reader panic, hang, or return an invalid mesh.

use std::time::{Duration, Instant};

use proptest::collection::vec;
use proptest::prelude::*;
use shape_up::mesh::{read, write_obj};
use shape_up::words;

const NAMES: [&str; 4] = ["a.obj", "a.off", "a.mesh", "a"];

/// Reads the bytes as every format and checks the invariants of `Mesh` on the result.
fn check(bytes: &[u8]) {
    for name in NAMES {
        let read = match read(name, bytes) {
            Ok(read) => read,
            Err(error) => {
                assert!(error.to_string().starts_with(name) && !error.message.is_empty());
                assert!(error.line.is_none_or(|line| (1..=bytes.len()).contains(&line)));
                continue;
            }
        };
        let mesh = &read.mesh;
        let vertices = mesh.positions.len() as u32;
        assert!(vertices > 0 && mesh.positions.as_flattened().iter().all(|x| x.is_finite()));
        for face in mesh.faces.iter() {
            let mut corners = face.to_vec();
            corners.sort_unstable();
            corners.dedup();
            assert!(face.len() >= 3 && corners.len() == face.len());
        }
        assert!(mesh.curves.iter().all(|curve| curve.len() >= 2));
        let indices = [mesh.faces.indices(), mesh.curves.indices(), mesh.tets.as_flattened()];
        assert!(indices.into_iter().flatten().all(|&vertex| vertex < vertices));
        for group in &mesh.groups {
            let ascend = |members: &[u32], count| {
                members.is_sorted_by(|a, b| a < b)
                    && members.iter().all(|&member| (member as usize) < count)
            };
            assert!(ascend(&group.faces, mesh.faces.len()));
            assert!(ascend(&group.curves, mesh.curves.len()));
        }
        for problem in &read.problems {
            assert!(problem.count > 0 && problem.line.is_some());
            assert!(problem.to_string().starts_with(&words::group_digits(problem.count)));
        }
        assert_eq!(
            write_obj(mesh, &mesh.positions).lines().next().map(|line| &line[..2]),
            Some("v ")
        );
    }
}

const SOUND: [&str; 3] = [
    "# \\\nmtllib a\no roof\nv 0 0 0 1\nv 1,5 0 0\nv 1 1e3 0\nv 0 -1 .5\nvt 0 0\ng a b\nusemtl c\n\
     f 1/1/1 2//1 3 \\\n 4\nf -1 -2 -3\nl 1 2 3 1\np 1\ncstype bspline\ndeg 1\ncurv 0 1 1 2\nend\n",
    "OFF4 2 0 # counts\n0 0 0\n1 0 0\n1 1 0\n0 1 0\n3 0 1 2 1.0 0 0\n4 0 1\n 2 3\n",
    "MeshVersionFormatted 1\nDimension 3\nVertices\n4\n0 0 0 0\n1 0 0 0\n0 1 0 0\n0 0 1 0\n\
     Triangles 1\n1 2 3 0\nNormals 1\n0 0 1\nEdges 1\n1 2 0\nTetrahedra 1\n1 2 3 4 0\nEnd\n",
];

/// One change to a file: position, inserted bytes, number of bytes removed.
fn mutate(bytes: &mut Vec<u8>, (place, put, take): (prop::sample::Index, Vec<u8>, usize)) {
    let begin = place.index(bytes.len() + 1);
    let end = bytes.len().min(begin + take);
    bytes.splice(begin..end, put);
}

/// Tokens that mean something to a reader.
fn piece() -> impl Strategy<Value = Vec<u8>> {
    let words = [
        "v ",
        "f ",
        "l ",
        "g ",
        "\n",
        "\r",
        "\\\n",
        "#",
        " ",
        "0 ",
        "1 ",
        "-1 ",
        "-9 ",
        "4 ",
        "/",
        ",",
        ".",
        "e999",
        "nan ",
        "99999999999999999999 ",
        "2147483648 ",
        "OFF",
        "4OFF",
        "BINARY",
        "\0",
        "Vertices ",
        "Triangles ",
        "Edges 1\n",
        "Dimension 2\n",
        "End\n",
        "curv 0 1 ",
        "deg 1\n",
        "\u{FEFF}",
        "\u{a0}",
    ];
    prop_oneof![
        4 => prop::sample::select(words.to_vec()).prop_map(|word| word.as_bytes().to_vec()),
        1 => vec(any::<u8>(), 0..4),
    ]
}

proptest! {
    #![proptest_config(crate::support::fuzz::cases(1000))]

    #[test]
    fn random_bytes(bytes in vec(any::<u8>(), 0..300)) {
        check(&bytes);
    }

    #[test]
    fn random_utf16(bytes in vec(any::<u8>(), 0..300)) {
        check(&[b"\xFF\xFE", &bytes[..]].concat());
    }

    #[test]
    fn random_statements(pieces in vec(piece(), 0..100)) {
        check(&pieces.concat());
    }

    #[test]
    fn sound_files_with_faults(
        file in prop::sample::select(&SOUND[..]),
        faults in vec((any::<prop::sample::Index>(), piece(), 0_usize..12), 0..6),
    ) {
        let mut bytes = file.as_bytes().to_vec();
        faults.into_iter().for_each(|fault| mutate(&mut bytes, fault));
        check(&bytes);
    }

    #[test]
    fn files_that_end_too_early(
        file in prop::sample::select(&SOUND[..]),
        end in any::<prop::sample::Index>(),
    ) {
        check(&file.as_bytes()[..end.index(file.len())]);
    }
}

#[test]
fn time_grows_no_faster_than_the_file() {
    const MANY: usize = 200_000;
    let vertices = "v 0 0 0\nv 1 0 0\nv 0 1 0\n";
    let names = (0..MANY).map(|i| format!(" {i}")).collect::<String>();
    let files = [
        format!("{vertices}f{}\n", " 1 2 3".repeat(MANY)),
        format!("{vertices}{}", "f 1 2 3\n".repeat(MANY)),
        format!("{vertices}g{names}\n{}", "f 1 2 3\n".repeat(MANY)),
        format!("{vertices}{}", "f 1 2 9\n".repeat(MANY)),
        format!("{vertices}f {}1 2 3", "\\\n".repeat(MANY)),
        format!("{vertices}{}", "#".repeat(10 * MANY)),
        format!("{vertices}o a\n{}", "g a\nf 1 2 3\ng b\n".repeat(MANY)),
        "v 0 0 0\n".repeat(MANY),
        "\r".repeat(10 * MANY),
        "OFF\n4000000000 4000000000 0\n".to_owned() + &"0 0 0\n".repeat(MANY),
        "OFF\n3 1 0\n0 0 0\n1 0 0\n0 1 0\n4000000000".to_owned() + &" 1 2".repeat(MANY),
        "MeshVersionFormatted 1 Vertices 4000000000\n".to_owned() + &"0 0 0\n".repeat(MANY),
        "Vertices 0 ".repeat(MANY),
    ];
    for file in files {
        let start = Instant::now();
        check(file.as_bytes());
        // Each takes well under a second; quadratic time would be minutes.
        let start_of_file: String = file.chars().take(60).collect();
        assert!(start.elapsed() < Duration::from_secs(20), "{start_of_file:?}");
    }
}
