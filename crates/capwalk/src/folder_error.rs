//! What can be wrong with the folder of a run.

use std::io;
use std::path::PathBuf;

use capwalk_inverse::variable::ApplyError;
use capwalk_scene_io::InputInTheWay;
use capwalk_scene_io::export::ExportError;
use capwalk_scene_io::image::ImageError;

/// Why a run cannot begin or go on in a folder.
#[derive(Debug, thiserror::Error)]
#[non_exhaustive]
pub enum FolderError {
    /// Nothing can be written there.
    #[error("cannot write into the folder {}", folder.display())]
    Unwritable {
        /// The folder.
        folder: PathBuf,
        /// Why.
        #[source]
        error: io::Error,
    },
    /// There is a run already, and it was not to be resumed.
    #[error("the folder {} already has a run", folder.display())]
    Taken {
        /// The folder.
        folder: PathBuf,
    },
    /// Another process is running there.
    #[error("another run is writing into {}; wait until it ends", folder.display())]
    Busy {
        /// The folder.
        folder: PathBuf,
    },
    /// The run would overwrite a file that it reads.
    #[error(transparent)]
    InputInTheWay(#[from] InputInTheWay),
    /// The run would overwrite something that is no run's.
    #[error(
        "{} already exists, and there is no checkpoint of a run that wrote it", file.display()
    )]
    ResultInTheWay {
        /// What is there.
        file: PathBuf,
    },
    /// A file that the run adds to is a link, which may lead to anything.
    #[error(
        "{} is a link; expected a file of the run's own, or none. Remove the link", file.display()
    )]
    LinkInTheWay {
        /// The link.
        file: PathBuf,
    },
    /// A file of the run cannot be read.
    #[error("cannot read {}", file.display())]
    Unreadable {
        /// The file.
        file: PathBuf,
        /// Why.
        #[source]
        error: io::Error,
    },
    /// A file of the run cannot be written.
    #[error("cannot write {}", file.display())]
    Unwritten {
        /// The file.
        file: PathBuf,
        /// Why.
        #[source]
        error: io::Error,
    },
    /// The record has fewer rows than the checkpoint knows.
    #[error(
        "{} lacks rows of the {iterations} iterations in the checkpoint; restore it, or \
         start in another folder",
        file.display()
    )]
    MissingRows {
        /// The record.
        file: PathBuf,
        /// Iterations of the checkpoint.
        iterations: u32,
    },
    /// The checkpoint is not the file that the run wrote.
    #[error(
        "the checkpoint is damaged: {0}; expected the file that the run wrote. Restore it, or \
         start in another folder"
    )]
    DamagedCheckpoint(ImageError),
    /// The checkpoint does not fit the job in a way that its fingerprint does not say.
    #[error("{} is no checkpoint of this job: {reason}", file.display())]
    NoCheckpoint {
        /// The checkpoint.
        file: PathBuf,
        /// Which array is wrong.
        reason: String,
    },
    /// The run in the folder was of another job.
    #[error(
        "the run in {} had another job and cannot continue with this one: {}. Undo the change, \
         or start in another folder",
        folder.display(), changed.join("; ")
    )]
    OtherJob {
        /// The folder.
        folder: PathBuf,
        /// What was and what is, for each thing that changed.
        changed: Vec<String>,
    },
    /// Arrays or images cannot be written.
    #[error(transparent)]
    Image(#[from] ImageError),
    /// The scene of the result cannot be written.
    #[error(transparent)]
    Export(#[from] ExportError),
    /// The state makes no scene.
    #[error(transparent)]
    Apply(#[from] ApplyError),
}
