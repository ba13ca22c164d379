//! A rig at a pose as a picture: its tree of frames, bodies, joints and forces from two or three sides, as SVG.
//!
//! `pose` says where everything is, `view` how space is laid onto paper, `picture` what is drawn, `svg` how it is
//! written. Knows checked rigs; knows nothing of equations, files and terminals.
#![forbid(unsafe_code)]

mod picture;
mod pose;
mod svg;
mod view;

pub use picture::picture;
pub use pose::{Arrow, Joint, Mass, Pose, pose, sample};
