"""The crane with sensors and a sampled controller, from event to event."""
