//! Writes files whole or not at all.

use std::{
    collections::BTreeSet,
    fs::{self, File, Metadata},
    io::{self, BufWriter, ErrorKind, Write},
    path::{Path, PathBuf},
    sync::{Mutex, MutexGuard, PoisonError},
};
use tempfile::NamedTempFile;

/// A file that is written, but not yet in its place. Dropped, it leaves what was there.
pub(crate) struct Written {
    target: PathBuf,
    /// `None` for what was written directly.
    beside: Option<Unfinished>,
}

/// A temporary file. It is removed when dropped, and by [`remove_unfinished`], which may find it gone.
struct Unfinished(NamedTempFile);

/// The paths of all [`Unfinished`] files, and of some that were dropped.
static UNFINISHED: Mutex<BTreeSet<PathBuf>> = Mutex::new(BTreeSet::new());

fn unfinished() -> MutexGuard<'static, BTreeSet<PathBuf>> {
    UNFINISHED.lock().unwrap_or_else(PoisonError::into_inner)
}

impl Unfinished {
    fn new(file: NamedTempFile) -> Self {
        unfinished().insert(file.path().to_owned());
        Self(file)
    }

    /// Renames it. Where that fails, it is removed.
    fn put(self, target: &Path) -> io::Result<()> {
        let path = self.0.path().to_owned();
        let placed = self.0.persist(target);
        unfinished().remove(&path);
        placed.map(|_| ()).map_err(|error| error.error)
    }
}

/// Removes the files that are being written: the program is about to end.
pub(crate) fn remove_unfinished() {
    for path in &*unfinished() {
        // It ends anyway.
        let _ = fs::remove_file(path);
    }
}

/// Writes a temporary file beside `path` and renames it to `path` once it is complete and on the disk. On any failure,
/// also of `write`, `path` keeps its contents and the temporary file is removed. A link stays: its target is replaced.
/// A read-only file stays as it is. A path that is no regular file, such as a pipe, is written directly, and so is
/// standard output, which is called `-`.
///
/// # Errors
/// The system's error, or that of `write`.
pub(crate) fn replace(
    path: &Path,
    write: impl FnOnce(&mut dyn Write) -> io::Result<()>,
) -> io::Result<()> {
    write_beside(path, write)?.put_in_place()
}

/// The first half of [`replace`]: all but the renaming.
///
/// # Errors
/// The system's error, or that of `write`.
pub(crate) fn write_beside(
    path: &Path,
    write: impl FnOnce(&mut dyn Write) -> io::Result<()>,
) -> io::Result<Written> {
    let target = target(path);
    let mut beside = None;
    if is_stdout(path) {
        write_all(&mut io::stdout().lock(), write)?;
        return Ok(Written { target, beside });
    }
    let before = fs::metadata(&target).ok();
    // A rename checks only the permissions of the folder.
    let is_fixed = |old: &Metadata| old.permissions().readonly();
    if before.as_ref().is_some_and(is_fixed) {
        return Err(ErrorKind::PermissionDenied.into());
    }
    if before.as_ref().is_some_and(|old| !old.is_file()) {
        write_all(&mut File::create(&target)?, write)?;
    } else {
        let Unfinished(new) = beside.insert(Unfinished::new(new_file(folder_of(&target))?));
        if let Some(old) = before {
            new.as_file().set_permissions(old.permissions())?;
        }
        write_all(new.as_file_mut(), write)?;
        new.as_file().sync_all()?;
    }
    Ok(Written { target, beside })
}

fn write_all(
    to: &mut dyn Write,
    write: impl FnOnce(&mut dyn Write) -> io::Result<()>,
) -> io::Result<()> {
    let mut out = BufWriter::new(to);
    write(&mut out)?;
    out.flush()
}

impl Written {
    /// Renames the temporary file into its place. What was written directly is already there.
    ///
    /// # Errors
    /// The system's error.
    pub fn put_in_place(self) -> io::Result<()> {
        match self.beside {
            Some(unfinished) => unfinished.put(&self.target),
            None => Ok(()),
        }
    }
}

/// Whether a path means standard output.
pub(crate) fn is_stdout(path: &Path) -> bool {
    path == "-"
}

/// The file that a path leads to, through links. It need not exist.
pub(crate) fn target(path: &Path) -> PathBuf {
    let in_folder = || {
        let folder = fs::canonicalize(folder_of(path)).ok()?;
        Some(folder.join(path.file_name()?))
    };
    let found = fs::canonicalize(path).ok().or_else(in_folder);
    found.unwrap_or_else(|| path.to_owned())
}

fn folder_of(path: &Path) -> &Path {
    let folder = path.parent();
    let folder = folder.filter(|folder| !folder.as_os_str().is_empty());
    folder.unwrap_or(Path::new("."))
}

/// A file of a unique name, removed when dropped, with the permissions of any new file.
fn new_file(folder: &Path) -> io::Result<NamedTempFile> {
    let mut new = tempfile::Builder::new();
    new.prefix(".sightline-").suffix(".part");
    #[cfg(unix)]
    new.permissions(std::os::unix::fs::PermissionsExt::from_mode(0o666));
    // The name of a temporary file says nothing to users: the common errors go without it.
    fs::metadata(folder)?;
    new.tempfile_in(folder).map_err(|error| match error.kind() {
        kind @ (ErrorKind::PermissionDenied
        | ErrorKind::ReadOnlyFilesystem
        | ErrorKind::StorageFull) => kind.into(),
        _ => error,
    })
}

#[cfg(test)]
mod tests {
    use super::replace;
    use std::{fs, io};

    #[test]
    fn a_failure_half_way_leaves_the_old_file_and_nothing_beside_it() {
        let folder = tempfile::tempdir().expect("a folder");
        let path = folder.path().join("scene.toml");
        fs::write(&path, "old").expect("writable");
        let full = |out: &mut dyn io::Write| {
            out.write_all(&vec![b'x'; 1 << 16])?;
            Err(io::ErrorKind::StorageFull.into())
        };
        let error = replace(&path, full).expect_err("a full disk");
        assert_eq!(error.kind(), io::ErrorKind::StorageFull);
        assert_eq!(fs::read(&path).expect("a file"), b"old");
        assert_eq!(fs::read_dir(folder.path()).expect("a folder").count(), 1);
        replace(&path, |out| out.write_all(b"new")).expect("room");
        assert_eq!(fs::read(&path).expect("a file"), b"new");
        replace(folder.path(), |out| out.write_all(b"new")).expect_err("a folder");
        let nowhere = folder.path().join("no/scene.toml");
        let error = replace(&nowhere, |out| out.write_all(b"new")).expect_err("no folder");
        assert_eq!(error.kind(), io::ErrorKind::NotFound);
        assert!(!error.to_string().contains(".part"), "{error}");
    }

    #[cfg(unix)]
    #[test]
    fn a_device_stays_one() {
        use std::os::unix::fs::FileTypeExt;
        let [null, full] = ["/dev/null", "/dev/full"].map(std::path::Path::new);
        replace(null, |out| out.write_all(b"new")).expect("room");
        let kind = fs::metadata(null).expect("a device").file_type();
        assert!(kind.is_char_device());
        if full.exists() {
            let error = replace(full, |out| out.write_all(b"new")).expect_err("a full disk");
            assert_eq!(error.kind(), io::ErrorKind::StorageFull);
        }
    }

    #[cfg(unix)]
    #[test]
    fn permissions_and_links_stay() {
        use std::os::unix::fs::{MetadataExt, PermissionsExt, symlink};
        let folder = tempfile::tempdir().expect("a folder");
        let [file, link, other] = ["file", "link", "other"].map(|name| folder.path().join(name));
        fs::write(&file, "old").expect("writable");
        fs::write(&other, "old").expect("writable");
        let plain = fs::metadata(&other).expect("a file").mode();
        fs::set_permissions(&file, fs::Permissions::from_mode(0o640)).expect("ours");
        symlink(&file, &link).expect("a link");
        replace(&link, |out| out.write_all(b"new")).expect("writable");
        assert!(fs::symlink_metadata(&link).expect("a link").is_symlink());
        assert_eq!(fs::read(&file).expect("a file"), b"new");
        let mode = fs::metadata(&file).expect("a file").mode();
        assert_eq!(mode & 0o777, 0o640);
        let made = folder.path().join("made");
        replace(&made, |out| out.write_all(b"new")).expect("writable");
        assert_eq!(fs::metadata(&made).expect("a file").mode(), plain);
        fs::set_permissions(&file, fs::Permissions::from_mode(0o440)).expect("ours");
        replace(&file, |out| out.write_all(b"newer")).expect_err("not to be written");
        assert_eq!(fs::read(&file).expect("a file"), b"new");
    }
}
