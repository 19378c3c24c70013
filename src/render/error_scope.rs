//! Hears what a device complains of while something is made or drawn; unheard, wgpu would end the program.

use std::future::Future;
use std::pin::pin;
use std::task::{Context, Poll, Waker};

/// Listens from `begin` to `end`, on this thread. Scopes must end in the reverse order, and fields are let go in this one.
pub(super) struct ErrorScope {
    memory: wgpu::ErrorScopeGuard,
    internal: wgpu::ErrorScopeGuard,
    validation: wgpu::ErrorScopeGuard,
}

impl ErrorScope {
    /// Begins to listen.
    pub fn begin(device: &wgpu::Device) -> Self {
        let scope = |filter| device.push_error_scope(filter);
        Self {
            validation: scope(wgpu::ErrorFilter::Validation),
            internal: scope(wgpu::ErrorFilter::Internal),
            memory: scope(wgpu::ErrorFilter::OutOfMemory),
        }
    }

    /// The first complaint since `begin`.
    pub fn end(self) -> Result<(), String> {
        let heard =
            [self.memory, self.internal, self.validation].map(|scope| finished(scope.pop()));
        match heard.into_iter().flatten().next() {
            Some(error) => Err(error.to_string()),
            None => Ok(()),
        }
    }
}

/// The answer of a future that native drivers answer at once.
pub(super) fn finished<T>(future: impl Future<Output = T>) -> T {
    let mut future = pin!(future);
    let mut context = Context::from_waker(Waker::noop());
    loop {
        if let Poll::Ready(answer) = future.as_mut().poll(&mut context) {
            return answer;
        }
        std::hint::spin_loop();
    }
}
